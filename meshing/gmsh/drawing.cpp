#include "meshing/gmsh/drawing.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <map>

namespace dda {
namespace {

std::vector<int> add_points(const std::vector<Vec2>& points, Frame& frame) {
  std::vector<int> tags;
  for (const Vec2& point : points) {
    const Vec2 x = frame.inner(point);
    tags.push_back(gmsh::model::occ::addPoint(x.x(), x.y(), 0));
  }
  return tags;
}

int add_loop(const Polygon& polygon, Frame& frame) {
  const std::vector<int> corners = add_points(polygon.vertices, frame);
  std::vector<int> lines;
  for (std::size_t i = 0; i < corners.size(); ++i)
    lines.push_back(gmsh::model::occ::addLine(corners[i], corners[(i + 1) % corners.size()]));
  return gmsh::model::occ::addCurveLoop(lines);
}

int add_shape(const Shape& shape, Frame& frame) {
  std::vector<int> loops{add_loop(shape.figure.outline, frame)};
  for (const Polygon& hole : shape.figure.holes) loops.push_back(add_loop(hole, frame));
  return gmsh::model::occ::addPlaneSurface(loops);
}

/// What was drawn and the layout's part it stands for: (dimension, tag) → group name.
using Drawn = std::vector<std::pair<std::pair<int, int>, std::string>>;

Drawn shapes_and_lines(const Layout& layout, Frame& frame) {
  Drawn drawn;
  for (const Shape& shape : layout.shapes)
    // Groups are numbered in the order of their names: leading zeros keep that of the regions.
    drawn.push_back({{2, add_shape(shape, frame)}, fmt::format("material:{:09}", shape.region)});
  for (const NamedLine& line : layout.lines) {
    const std::vector<int> points = add_points(line.points, frame);
    const char* role = line.role == LineRole::interface ? "interface:"
                       : line.role == LineRole::slit    ? "slit:"
                                                        : "boundary:";
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      drawn.push_back({{1, gmsh::model::occ::addLine(points[i], points[i + 1])}, role + line.name});
  }
  return drawn;
}

/// Cuts everything drawn by everything else and names the pieces.
void fragment(const Drawn& drawn) {
  gmsh::vectorpair objects, tools, pieces;
  for (const auto& [entity, name] : drawn) objects.push_back(entity);
  std::vector<gmsh::vectorpair> pieces_of{objects};  // of a single shape, which gmsh does not cut by nothing
  if (objects.size() > 1) gmsh::model::occ::fragment(objects, tools, pieces, pieces_of);
  gmsh::model::occ::synchronize();
  std::map<std::pair<int, std::string>, std::vector<int>> groups;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (const auto& [dimension, tag] : pieces_of[i]) groups[{dimension, drawn[i].second}].push_back(tag);
  for (const auto& [key, entities] : groups)
    gmsh::model::setPhysicalName(key.first, gmsh::model::addPhysicalGroup(key.first, entities), key.second);
}

}  // namespace

void draw(const Layout& layout, Frame& frame) { fragment(shapes_and_lines(layout, frame)); }

}  // namespace dda
