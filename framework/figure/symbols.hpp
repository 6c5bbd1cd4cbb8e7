#pragma once

#include <vector>

#include "framework/figure/drawing.hpp"
#include "framework/figure/view.hpp"

namespace dda::svg {

/// Room that symbols take outside the bounds of what they stand on [px].
inline constexpr double symbol_reach = 54;
/// Height of a line of the legend [px].
inline constexpr double key_line = 18;

/// Paints forces, of one colour by their size, and the other marks. Of those of one kind and direction that stand closer than a symbol's breadth one
/// is painted, with all their names: a load along a side looks like one. Others that stand at one place are painted side by
/// side. Names find room beside them, clear of each other.
void paint_symbols(Canvas& canvas, const View& view, const std::vector<Symbol>& symbols);

/// Paints the legend downwards from a place [px]; gives the width used.
double paint_key(Canvas& canvas, const std::vector<KeyEntry>& key, const Vec2& corner);

}  // namespace dda::svg
