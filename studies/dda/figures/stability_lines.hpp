#pragma once

#include <array>

#include "framework/figure/style.hpp"

namespace dda {

/// How a part of a curve is drawn.
struct StabilityLine {
  const char* name;  ///< in a legend
  int colour;        ///< in the palette; -1: the curve's own
  bool dashed, dotted;
  const char* explanation;  ///< below a figure
};

/// In the order of Stability.
inline constexpr std::array<StabilityLine, 4> stability_lines{
    {{"stable under dead load", -1, false, false, ""},
     {"stable under the control only", -1, true, false,
      "Dashed: stable under the control only; under a dead load the structure would fail here."},
     {"unstable", svg::vermilion, true, false, "Dashed in orange: unstable under the control, too."},
     {"stability not known", svg::black, false, true, "Dotted: it is not known whether it is stable."}}};

}  // namespace dda
