#pragma once

#include <cmath>
#include <string>

#include "framework/deck/document/node.hpp"
#include "meshing/scene/scene.hpp"

namespace dda {

/// The scene written in YAML, read as a deck would read it.
inline Scene scene_from(const std::string& yaml) {
  return scene_schema().read(parse_yaml(yaml, "deck.yaml"));
}

inline Assembly mesh_of(const std::string& yaml) { return mesh(scene_from(yaml)); }

/// What mesh() or the reader reports about a scene that cannot be used; empty when it can.
inline std::string complaint(const std::string& yaml) {
  try {
    mesh_of(yaml);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline Block block_of(std::vector<Vec2> vertices) {
  const Polygon outline{std::move(vertices)};
  return {outline, moments(outline), 0};
}

inline Block square_at(double x, double y, double width = 1, double height = 1) {
  return block_of({{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}});
}

inline double length(const Vec2& start, const Vec2& end) { return (end - start).norm(); }

inline double total_area(const Assembly& assembly) {
  double sum = 0;
  for (const Block& block : assembly.blocks) sum += block.moments.area;
  return sum;
}

/// Length of all sides on the named curve.
inline double length_on_curve(const Assembly& assembly, const std::string& name) {
  double sum = 0;
  for (const Side& side : assembly.sides)
    if (side.curve && assembly.curves[static_cast<std::size_t>(*side.curve)] == name)
      sum += length(side.start, side.end);
  return sum;
}

inline double boundary_length(const Assembly& assembly) {
  double sum = 0;
  for (const BoundarySide& side : assembly.boundary) sum += length(side.start, side.end);
  return sum;
}

/// Largest difference, over all blocks, of the perimeter and of what sides and boundary cover of it.
inline double uncovered_perimeter(const Assembly& assembly) {
  std::vector<double> rest;
  for (const Block& block : assembly.blocks) rest.push_back(perimeter(block.outline));
  for (const Side& side : assembly.sides)
    for (const BlockId block : {side.first, side.second}) rest[block.value()] -= length(side.start, side.end);
  for (const BoundarySide& side : assembly.boundary) rest[side.block.value()] -= length(side.start, side.end);
  double worst = 0;
  for (const double r : rest) worst = std::max(worst, std::abs(r));
  return worst;
}

/// A beam of two regions with a ligament above a notch of no width at x = 150.
inline std::string notched_beam(const std::string& subdivision) {
  return R"(
regions:
  - {name: left, material: concrete, vertices: [[0, 0], [150, 0], [150, 100], [0, 100]]}
  - {name: right, material: concrete, vertices: [[150, 0], [300, 0], [300, 100], [150, 100]]}
curves: {ligament: [[150, 16], [150, 100]]}
slits: {notch: [[150, 0], [150, 16]]}
boundaries: {top: [[100, 100], [200, 100]]}
subdivision: )" +
         subdivision + "\n";
}

}  // namespace dda
