#pragma once

#include <string>

namespace dda::svg {

enum class ColourMap {
  viridis,         ///< dark blue to yellow, even in lightness. Source: Smith & van der Walt, matplotlib (CC0)
  crack,           ///< yellow to dark red
  violet_to_green  ///< violet for negative, white for none, green for positive numbers
};

/// The colour "#rrggbb" at `part` in 0 to 1, clamped; light grey for NaN.
std::string colour(ColourMap map, double part);

}  // namespace dda::svg
