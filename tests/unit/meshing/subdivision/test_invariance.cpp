#include <fmt/format.h>
#include <gtest/gtest.h>

#include "unit/meshing/scene_example.hpp"

namespace dda {
namespace {

/// x ↦ unit (Q x + shift).
struct Move {
  double unit = 1, turn = 0;
  Vec2 shift = Vec2::Zero();

  Vec2 of(const Vec2& x) const {
    return unit * (Vec2{std::cos(turn) * x.x() - std::sin(turn) * x.y(),
                        std::sin(turn) * x.x() + std::cos(turn) * x.y()} +
                   shift);
  }
};

std::string moved(const std::vector<Vec2>& points, const Move& move) {
  std::string out;
  for (const Vec2& point : points) {
    const Vec2 x = move.of(point);
    out += fmt::format("{}[{:.17g}, {:.17g}]", out.empty() ? "" : ", ", x.x(), x.y());
  }
  return "[" + out + "]";
}

/// A notched beam of two regions, with a hole; `subdivision` has the place of a length of 12.5.
Assembly beam(const std::string& subdivision, const Move& move) {
  return mesh_of(
      fmt::format("{{regions: [{{name: left, material: stone, vertices: {}}}, {{name: right, material: "
                  "stone, vertices: {}}}], "
                  "curves: {{ligament: {}}}, slits: {{notch: {}}}, holes: {{duct: {}}}, subdivision: {}}}",
                  moved({{0, 0}, {200, 0}, {200, 30}, {200, 100}, {0, 100}}, move),
                  moved({{200, 0}, {400, 0}, {400, 100}, {200, 100}, {200, 30}}, move),
                  moved({{200, 30}, {200, 100}}, move), moved({{200, 0}, {200, 30}}, move),
                  moved({{70, 30}, {110, 45}, {80, 70}}, move),
                  fmt::format(fmt::runtime(subdivision), move.unit * 12.5, move.unit * 3)));
}

class Division : public ::testing::TestWithParam<const char*> {};

/// Another unit, place or turn of a structure gives the same blocks in the same order.
TEST_P(Division, MovesWithTheStructure) {
  const Assembly known = beam(GetParam(), {});
  for (const Move& move : {Move{1e-3, 0, {0, 0}}, Move{1 / 25.4, 0, {0, 0}}, Move{1, 0, {1234.5, -77.7}},
                           Move{1, 0.3, {0, 0}}, Move{7, 2.7, {-31.7, 3.3}}}) {
    const Assembly found = beam(GetParam(), move);
    ASSERT_EQ(found.num_blocks(), known.num_blocks()) << move.unit << " " << move.turn;
    ASSERT_EQ(found.sides.size(), known.sides.size());
    for (std::size_t i = 0; i < known.blocks.size(); ++i)
      EXPECT_LT((found.blocks[i].moments.centroid - move.of(known.blocks[i].moments.centroid)).norm(),
                1e-6 * move.unit);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Subdivisions, Division,
    ::testing::Values("{{type: triangles, size: {0:.17g}}}", "{{type: quads, size: {0:.17g}}}",
                      "{{type: triangles, size: {0:.17g}, refine: {{curve: ligament, size: {1:.17g}}}}}",
                      "{{type: voronoi, size: {0:.17g}, seed: 3}}", "{{type: voronoi, blocks: 200}}"));

}  // namespace
}  // namespace dda
