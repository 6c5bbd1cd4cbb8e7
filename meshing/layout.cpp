#include "meshing/layout.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "meshing/geometry/box_grid.hpp"
#include "meshing/geometry/geos.hpp"

namespace dda {
namespace {

constexpr double allowed_overlap = 1e-6;  // of the smaller area

/// Does an edge of convex polygon a have all of b on its outer side, to rounding?
bool edge_separates(const Polygon& a, const Polygon& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 edge = a.at(i + 1) - a.at(i);
    const double slack = 1e-9 * edge.squaredNorm();
    if (std::all_of(b.vertices.begin(), b.vertices.end(),
                    [&](const Vec2& x) { return cross(edge, x - a.at(i)) <= slack; }))
      return true;
  }
  return false;
}

double overlap(const Polygon& a, const Polygon& b) {
  if (!is_convex(a) || !is_convex(b)) return common_area({a, {}}, {b, {}});
  return edge_separates(a, b) || edge_separates(b, a) ? 0 : convex_overlap(a, b);
}

std::string name_of(const Layout& layout, const Shape& shape) {
  return "region '" + layout.regions[static_cast<std::size_t>(shape.region)].name + "'";
}

void rotate(Polygon& polygon, const Eigen::Matrix2d& turn) {
  for (Vec2& x : polygon.vertices) x = turn * x;
}

}  // namespace

Cells with_deck_lines(Cells cells, const Layout& layout) {
  for (const NamedLine& line : layout.lines)
    if (!line.from_file) cells.lines.push_back(line);
  return cells;
}

Cell uncut(const Shape& shape, const Layout& layout) {
  if (!shape.figure.holes.empty())
    throw InputError(shape.where, name_of(layout, shape) +
                                      " is to be one block and has a hole inside, which no block has: give a "
                                      "`subdivision`, or make it of several regions");
  return {shape.figure.outline, shape.region};
}

double scene_size(const Layout& layout) {
  Box box;
  for (const Shape& shape : layout.shapes)
    for (const Vec2& x : shape.figure.outline.vertices) box.include(x);
  return box.size();
}

TurnedLayout::TurnedLayout(const Layout& layout)
    : inner(layout), outer_(layout), axes_(axes_along(layout.shapes.front().figure.outline)) {
  const Eigen::Matrix2d turn = axes_.transpose();
  for (Shape& shape : inner.shapes) {
    rotate(shape.figure.outline, turn);
    for (Polygon& hole : shape.figure.holes) rotate(hole, turn);
  }
  for (NamedLine& line : inner.lines)
    for (Vec2& x : line.points) x = turn * x;
}

Cells TurnedLayout::back(Cells cells) const {
  for (Cell& cell : cells.cells) rotate(cell.outline, axes_);
  cells.lines = outer_.lines;
  return cells;
}

std::vector<std::pair<std::size_t, std::size_t>> overlapping(const std::vector<Polygon>& outlines) {
  std::vector<Box> boxes;
  for (const Polygon& outline : outlines) boxes.push_back(bounding_box(outline.vertices));
  std::vector<std::pair<std::size_t, std::size_t>> found;
  BoxGrid(std::move(boxes)).for_each_pair([&](std::size_t i, std::size_t j) {
    const double smaller = std::min(signed_area(outlines[i]), signed_area(outlines[j]));
    if (overlap(outlines[i], outlines[j]) > allowed_overlap * smaller)
      found.emplace_back(std::min(i, j), std::max(i, j));
  });
  std::sort(found.begin(), found.end());
  return found;
}

void check(const Layout& layout, Findings& findings) {
  if (layout.shapes.empty()) return findings.add(layout.where, "the scene has no region");
  std::vector<Polygon> sound;
  std::vector<const Shape*> source;
  for (const Shape& shape : layout.shapes) {
    if (const auto wrong = defect(shape.figure.outline)) {
      findings.add(shape.where, name_of(layout, shape) + " " + *wrong);
      continue;
    }
    if (!shape.figure.holes.empty()) continue;
    sound.push_back(shape.figure.outline);
    source.push_back(&shape);
  }
  for (const auto& [i, j] : overlapping(sound))
    findings.add(source[j]->where,
                 fmt::format("{} overlaps {}", name_of(layout, *source[j]), name_of(layout, *source[i])));
}

void require_sound(const Layout& layout) {
  Findings findings;
  check(layout, findings);
  findings.throw_if_any();
}

}  // namespace dda
