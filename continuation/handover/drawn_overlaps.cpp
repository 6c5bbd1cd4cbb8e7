#include "continuation/handover/drawn_overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "continuation/handover/regions.hpp"
#include "meshing/geometry/box_grid.hpp"

namespace dda {
namespace {

/// How deep x is inside; 0 outside [L].
double depth_of(const Vec2& x, const Polygon& outline) {
  if (!contains(outline, x, 0)) return 0;
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < outline.size(); ++e)
    out = std::min(out, distance(x, outline.at(e), outline.at(e + 1)));
  return out;
}

/// Lets `overlap` tell of the deepest corner of a in b.
void look_for_corners(const Polygon& a, const Polygon& b, DrawnOverlap& overlap) {
  for (const Vec2& x : a.vertices)
    if (const double depth = depth_of(x, b); depth > overlap.depth) {
      overlap.depth = depth;
      overlap.at = x;
    }
}

DrawnOverlap overlap_of(const Body& body, std::size_t i, std::size_t j, double scene) {
  constexpr double of_block = 1e-6, of_scene = 1e-9;  // within which sides have each other for neighbours
  const Block &one = body.assembly.blocks[i], &other = body.assembly.blocks[j];
  DrawnOverlap out{.first = i, .second = j};
  out.touching =
      std::max(of_block * std::sqrt(std::min(one.moments.area, other.moments.area)), of_scene * scene);
  look_for_corners(one.outline, other.outline, out);
  look_for_corners(other.outline, one.outline, out);
  return out;
}

}  // namespace

std::vector<DrawnOverlap> drawn_overlaps(const Body& body, const MotionParameters& parameters) {
  constexpr double rounding = 1e-3;  // of what drawings round: that of places
  std::vector<Box> boxes;
  Box all;
  for (const Block& block : body.assembly.blocks) {
    boxes.push_back(bounding_box(block.outline.vertices));
    for (const Vec2& x : block.outline.vertices) all.include(x);
  }
  std::vector<DrawnOverlap> out;
  const auto stays = [&](std::size_t b) { return is_held(body, parameters, body.assembly.blocks[b].region); };
  BoxGrid(std::move(boxes)).for_each_pair([&](std::size_t i, std::size_t j) {
    if (stays(i) && stays(j)) return;
    const DrawnOverlap found = overlap_of(body, std::min(i, j), std::max(i, j), all.size());
    if (found.depth > rounding * found.touching) out.push_back(found);
  });
  std::ranges::sort(out, {}, [](const DrawnOverlap& of) { return std::pair(of.first, of.second); });
  return out;
}

std::vector<double> set_back(const Body& body, const MotionParameters& parameters) {
  const std::vector<Block>& blocks = body.assembly.blocks;
  std::vector<double> out(blocks.size(), 0.0);
  for (const DrawnOverlap& overlap : drawn_overlaps(body, parameters)) {
    const auto [i, j] = std::pair(overlap.first, overlap.second);
    const bool is_smaller = blocks[i].moments.area < blocks[j].moments.area;
    const bool takes_first = is_held(body, parameters, blocks[j].region) ||
                             (is_smaller && !is_held(body, parameters, blocks[i].region));
    double& back = out[takes_first ? i : j];
    back = std::max(back, std::min(overlap.depth, overlap.touching));
  }
  return out;
}

}  // namespace dda
