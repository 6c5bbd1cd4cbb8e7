#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/base/errors.hpp"
#include "meshing/assembly.hpp"
#include "meshing/neighbours.hpp"

namespace dda {

class GmshModel;

/// A named polyline of the scene.
struct NamedLine {
  LineRole role = LineRole::interface;
  std::string name;
  std::vector<Vec2> points;
  Position where;
  bool from_file = false;  ///< drawn in the gmsh file; the mesh made of it has its own pieces
};

/// One connected piece of a region.
struct Shape {
  Figure figure;
  int region = 0;  ///< index into Layout::regions
  Position where;
};

/// The scene before it is cut into blocks. A gmsh file keeps its model, so that it can be meshed as drawn.
struct Layout {
  std::vector<Region> regions;
  std::vector<Shape> shapes;
  std::vector<NamedLine> lines;
  std::map<std::string, Vec2> points;
  Position where;
  double meshing_seconds = 600;            ///< that gmsh may take for one answer [s]
  std::shared_ptr<const GmshModel> model;  ///< null where the scene is made of polygons
};

/// An outline cut from a region, counter-clockwise.
struct Cell {
  Polygon outline;
  int region = 0;
};

/// The cells of a layout and the named lines in the form that their sides follow.
struct Cells {
  std::vector<Cell> cells;
  std::vector<NamedLine> lines;
};

/// Cells meshed from the layout's gmsh model, with the lines that the deck adds to those of the mesh.
Cells with_deck_lines(Cells cells, const Layout& layout);

/// A shape as one cell. Throws InputError where it has holes, which no cell has.
Cell uncut(const Shape& shape, const Layout& layout);

/// Length by which tolerances are measured: the larger extent of all shapes [L].
double scene_size(const Layout& layout);

/// The layout in the axes of its first shape's first side, and cells in those of the plane again, with the layout's own
/// lines: what is divided there is the same blocks however the structure is turned.
struct TurnedLayout {
  explicit TurnedLayout(const Layout& layout);
  Cells back(Cells cells) const;

  Layout inner;

 private:
  const Layout& outer_;
  Eigen::Matrix2d axes_;
};

/// Pairs of cells that share more than 1e-6 of the smaller one's area.
std::vector<std::pair<std::size_t, std::size_t>> overlapping(const std::vector<Polygon>& outlines);

/// Reports shapes that are no simple polygons, that overlap, or that are missing altogether.
void check(const Layout& layout, Findings& findings);

/// The same, throwing InputError: for subdivisions that work on outlines, which a file may have drawn badly.
void require_sound(const Layout& layout);

}  // namespace dda
