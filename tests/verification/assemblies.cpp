#include "verification/assemblies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "support/random.hpp"

namespace dda::verification {

std::string points_text(const std::vector<Vec2>& points) {
  std::string out;
  for (const Vec2& x : points)
    out += fmt::format("{}[{:.17g}, {:.17g}]", out.empty() ? "" : ", ", x.x(), x.y());
  return "[" + out + "]";
}

std::string scene_text(const Drawing& drawing) {
  std::string out = "scene:\n  regions:\n";
  for (std::size_t i = 0; i < drawing.regions.size(); ++i)
    out += fmt::format("    - {{name: region{}, material: {}, vertices: {}}}\n", i, drawing.regions[i].first,
                       points_text(drawing.regions[i].second.vertices));
  out += "  boundaries:\n";
  for (std::size_t i = 0; i < drawing.outline.size(); ++i)
    out +=
        fmt::format("    side{}: {}\n", i, points_text({drawing.outline.at(i), drawing.outline.at(i + 1)}));
  return out + "  subdivision: " + drawing.subdivision + "\n";
}

Polygon random_convex(std::size_t corners, const Vec2& half_axes, std::uint64_t seed) {
  Random random(seed);
  Polygon out;
  for (std::size_t i = 0; i < corners; ++i) {
    const double share = (static_cast<double>(i) + random.between(0.1, 0.9)) / static_cast<double>(corners);
    const double angle = 2 * std::numbers::pi * share;
    out.vertices.emplace_back(half_axes.x() * std::cos(angle), half_axes.y() * std::sin(angle));
  }
  return out;
}

std::vector<Polygon> random_pieces(const Polygon& convex, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Polygon> pieces{convex};
  while (pieces.size() < count) {
    const auto largest = std::ranges::max_element(pieces, {}, signed_area);
    const Moments whole = moments(*largest);
    const Vec2 a = whole.centroid + random.point(0.1 * std::sqrt(whole.area));
    const double angle = random.between(0, std::numbers::pi);
    const Vec2 b = a + Vec2(std::cos(angle), std::sin(angle));
    Polygon left = left_part(*largest, a, b);
    *largest = left_part(*largest, b, a);
    pieces.push_back(std::move(left));
  }
  return pieces;
}

Polygon rectangle(const Vec2& low, const Vec2& high) {
  return {{low, {high.x(), low.y()}, high, {low.x(), high.y()}}};
}

}  // namespace dda::verification
