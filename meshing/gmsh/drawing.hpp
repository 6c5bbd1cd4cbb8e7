#pragma once

#include "meshing/layout.hpp"

namespace dda {

/// Draws a layout of polygons into the current gmsh model: all shapes and lines, each cut by all others, in
/// physical groups material:NUMBER (of the layout's region), interface:NAME, boundary:NAME, slit:NAME.
void draw(const Layout& layout);

}  // namespace dda
