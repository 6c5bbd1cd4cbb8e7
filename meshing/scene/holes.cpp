#include "meshing/scene/holes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "meshing/geometry/geos.hpp"

namespace dda {
namespace {

constexpr double hardly_any = 1e-9;  // of the hole's area

std::vector<Vec2> ring_of(const Polygon& outline) {
  std::vector<Vec2> out = outline.vertices;
  out.push_back(out.front());
  return out;
}

double shared_area(const Figure& figure, const Hole& hole) {
  const Box box = bounding_box(figure.outline.vertices);
  return box.touches(bounding_box(hole.outline.vertices)) ? common_area(figure, {hole.outline, {}}) : 0;
}

/// What is left of a shape that shares an area with a hole.
std::vector<Shape> left_of(const Shape& shape, const Hole& hole) {
  std::vector<Shape> out;
  for (Figure& part : cut(shape.figure, {ring_of(hole.outline)})) {
    part.outline = counter_clockwise(part.outline);
    if (2 * shared_area(part, hole) < area(part)) out.push_back({std::move(part), shape.region, shape.where});
  }
  return out;
}

bool is_boundary(const Layout& layout, const std::string& name) {
  return std::ranges::any_of(layout.lines, [&](const NamedLine& line) {
    return line.role == LineRole::boundary && line.name == name;
  });
}

void check(const std::vector<Hole>& holes, const Layout& layout, Findings& findings) {
  std::vector<Polygon> outlines;
  for (const Hole& hole : holes) {
    if (const auto wrong = defect(hole.outline))
      findings.add(hole.where, "hole '" + hole.name + "' " + *wrong);
    else
      outlines.push_back(hole.outline);
    if (is_boundary(layout, hole.name))
      findings.add(
          hole.where,
          fmt::format("'{}' is a boundary and a hole: the outline of a hole is a boundary of its name",
                      hole.name));
  }
  if (outlines.size() < holes.size()) return;
  for (const auto& [i, j] : overlapping(outlines))
    findings.add(holes[j].where, fmt::format("hole '{}' overlaps hole '{}'", holes[j].name, holes[i].name));
}

}  // namespace

void cut_holes(const std::vector<Hole>& holes, Layout& layout, Findings& findings) {
  check(holes, layout, findings);
  if (!findings.empty()) return;
  for (const Hole& hole : holes) {
    std::vector<Shape> left;
    bool lies_in_one = false;
    for (Shape& shape : layout.shapes) {
      const bool is_cut = shared_area(shape.figure, hole) > hardly_any * signed_area(hole.outline);
      lies_in_one = lies_in_one || is_cut;
      if (is_cut)
        std::ranges::move(left_of(shape, hole), std::back_inserter(left));
      else
        left.push_back(std::move(shape));
    }
    if (!lies_in_one) findings.add(hole.where, fmt::format("hole '{}' lies in no region", hole.name));
    layout.shapes = std::move(left);
    layout.lines.push_back({LineRole::boundary, hole.name, ring_of(hole.outline), hole.where});
  }
}

}  // namespace dda
