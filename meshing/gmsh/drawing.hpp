#pragma once

#include "meshing/gmsh/frame.hpp"

namespace dda {

/// Draws a layout of polygons, in the frame's inner coordinates, into the current gmsh model: all shapes and lines, each cut by all others, in
/// physical groups material:NUMBER (of the layout's region), interface:NAME, boundary:NAME, slit:NAME.
void draw(const Layout& layout, Frame& frame);

}  // namespace dda
