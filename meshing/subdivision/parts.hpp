#pragma once

#include <functional>

#include "meshing/geometry/geos.hpp"
#include "meshing/layout.hpp"

namespace dda {

/// A part of a shape that no interface or slit crosses from border to border.
struct LayoutPart {
  Figure figure;
  int region = 0;
};

std::vector<LayoutPart> parts_of(const Layout& layout);

/// What `cells(i)` makes of each part, in their order, cut along the lines that end within one. Asked in parallel.
Cells cells_of_parts(const Layout& layout, const std::vector<LayoutPart>& parts,
                     const std::function<std::vector<Polygon>(std::size_t)>& cells);

}  // namespace dda
