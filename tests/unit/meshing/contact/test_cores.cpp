#include <gmock/gmock.h>

#include <random>

#include "meshing/contact/free_way.hpp"
#include "meshing/contact/narrow.hpp"
#include "meshing/contact/outline.hpp"

namespace dda {
namespace {

const Polygon square{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}};

TEST(Core, StandsBackBySOnEverySide) {
  const Polygon core = core_of(square, 0.1);
  ASSERT_EQ(core.size(), 4u);
  EXPECT_NEAR(signed_area(core), 1.8 * 1.8, 1e-14);
}

TEST(Core, LosesSidesThatItWouldTurnRound) {
  const Polygon bevelled{{{0, 0}, {2, 0}, {2, 1.99}, {1.99, 2}, {0, 2}}};
  EXPECT_EQ(core_of(bevelled, 0.1).size(), 4u);
  EXPECT_EQ(core_of(bevelled, 0.001).size(), 5u);
}

TEST(Core, KeepsAReEntrantCorner) {
  const Polygon ell{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  const Polygon core = core_of(ell, 0.1);
  ASSERT_EQ(core.size(), 6u);
  EXPECT_NEAR(signed_area(core), 1.8 * 0.8 + 0.8 * 1.0, 1e-14);
}

TEST(Core, RefusesWhatIsTooNarrow) {
  EXPECT_THROW(core_of(Polygon{{{0, 0}, {2, 0}, {2, 0.1}, {0, 0.1}}}, 0.1), std::domain_error);
}

double sum_over_facings(const Vec2& x, double reach) {
  double sum = 0;
  for_each_facing(x, square.vertices, reach, [&](const Facing& facing) {
    const double overlap = reach - facing.distance;
    sum += overlap * overlap;
  });
  return sum;
}

TEST(Facing, IsContinuousWhereAFootLeavesAnEdgeForItsCorner) {
  constexpr double reach = 0.2, step = 1e-7;
  for (double angle = -0.5; angle < 2.1; angle += 0.01) {
    const auto at = [&](double a) { return Vec2(Vec2(2, 2) + 0.1 * Vec2(std::cos(a), std::sin(a))); };
    EXPECT_NEAR(sum_over_facings(at(angle), reach), sum_over_facings(at(angle + step), reach), 1e-6);
  }
}

TEST(FreeWay, NeverLetsOutlinesTouch) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-1, 1);
  const Polygon other{{{2.2, 0.5}, {3.2, 0.2}, {3.0, 1.6}}};
  for (int i = 0; i < 200; ++i) {
    std::vector<Vec2> v, w;
    for (std::size_t k = 0; k < 4; ++k) v.push_back(3 * Vec2(part(random), part(random)));
    for (std::size_t k = 0; k < 3; ++k) w.push_back(3 * Vec2(part(random), part(random)));
    const double share = free_way({square.vertices, v}, {other.vertices, w}, 0.2, 1);
    ASSERT_GT(share, 0);
    Polygon a = square, b = other;
    for (std::size_t k = 0; k < 4; ++k) a.vertices[k] += share * v[k];
    for (std::size_t k = 0; k < 3; ++k) b.vertices[k] += share * w[k];
    double nearest = 1e300;
    for (const Vec2& x : a.vertices)
      for (std::size_t e = 0; e < 3; ++e) nearest = std::min(nearest, distance(x, b.at(e), b.at(e + 1)));
    for (const Vec2& x : b.vertices)
      for (std::size_t e = 0; e < 4; ++e) nearest = std::min(nearest, distance(x, a.at(e), a.at(e + 1)));
    EXPECT_GT(nearest, 0.2 * 0.2 * 0.99);  // a fifth of the distance at first
  }
}

}  // namespace
}  // namespace dda
