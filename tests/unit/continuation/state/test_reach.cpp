#include <gtest/gtest.h>

#include <cmath>

#include "continuation/state/reach.hpp"
#include "support/law_case.hpp"

namespace dda {
namespace {

std::unique_ptr<InterfaceLaw> softening() {
  return interface_laws()
      .choose(parse_yaml(
          "{type: linear_softening, tensile_strength: 3, fracture_energy: 0.1, shear_weight: 0.7}", "d"))
      .make();
}

/// A point that has opened as far as `kappa` before.
class Point {
 public:
  explicit Point(double kappa) { remembered(*law_, history_, "kappa").front() = kappa; }
  double reach(const Vec2& a, const Vec2& b) const { return dda::reach(at(), a, b); }
  double opening(const Vec2& q) const { return at().opening(q); }

 private:
  LawAt at() const { return {*law_, history_, 1000}; }
  const std::unique_ptr<InterfaceLaw> law_ = softening();
  History history_;
};

TEST(Reach, ProportionalOpeningIsScaled) {
  EXPECT_DOUBLE_EQ(Point(0.05).reach({0, 0}, {0.02, 0}), 2.5);
  EXPECT_DOUBLE_EQ(Point(0.07).reach({0, 0}, {-3, 0.1}), 1) << "closing does not count, sliding does";
}

TEST(Reach, NeverReached) {
  EXPECT_TRUE(std::isinf(Point(0.05).reach({0, 0}, {-1, 0})));
  EXPECT_TRUE(std::isinf(Point(0.05).reach({0, 0}, {0, 0})));
  EXPECT_TRUE(std::isinf(Point(INFINITY).reach({0, 0}, {1, 0})));
}

TEST(Reach, LandsOnKappaAndStaysBeyondIt) {
  Random random(8);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec2 a = random.point(0.02), b = random.point(1);
    const double kappa = random.between(0.03, 0.06);
    const Point point(kappa);
    const double x = point.reach(a, b);
    if (!std::isfinite(x)) continue;
    ++found;
    EXPECT_NEAR(point.opening(a + x * b) / kappa, 1, 1e-13);
    EXPECT_GT(point.opening(a + 1.01 * x * b), kappa);
    EXPECT_LT(point.opening(a + 0.99 * x * b), kappa);
  }
  EXPECT_GT(found, 200);
}

class ReachOf : public testing::TestWithParam<std::string> {};

/// The first place in (0, end) of a fine grid behind which the opening is above κ and before which it is not.
double first_rise(const LawAt& point, const Vec2& a, const Vec2& b, double end) {
  constexpr int places = 4000;
  bool was_above = point.opening(a) >= point.kappa();
  for (int i = 1; i <= places; ++i) {
    const double x = end * i / places;
    const bool is_above = point.opening(a + x * b) >= point.kappa();
    if (is_above && !was_above) return x;
    was_above = is_above;
  }
  return INFINITY;
}

/// Every law at random histories against a search in small steps.
TEST_P(ReachOf, IsTheFirstRiseThroughKappa) {
  Random random(9);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const LawCase at = random_law(GetParam(), random, i % 2 == 0);
    const History h = at.reachable(random, i % 4);
    const LawAt point{*at.law, h, at.k};
    const Vec2 b = random.point(at.first);
    Vec2 a = random.point(at.first);
    while (point.opening(a) >= point.kappa()) a *= 0.5;
    const double x = reach(point, a, b);
    if (!std::isfinite(x)) {
      EXPECT_EQ(first_rise(point, a, b, 100), INFINITY) << at.text();
      continue;
    }
    ++found;
    EXPECT_NEAR(point.opening(a + x * b) / point.kappa(), 1, 1e-12);
    EXPECT_NEAR(first_rise(point, a, b, 1.5 * x), x, 1.5 * x / 4000 * 1.01)
        << "a " << a.transpose() / at.first << ", b " << b.transpose() / at.first << ", kappa "
        << point.kappa() / at.first << "\n"
        << at.text();
  }
  EXPECT_GE(found, GetParam().find("softening") != std::string::npos ? 60 : 0);
}

INSTANTIATE_TEST_SUITE_P(Registry, ReachOf, testing::ValuesIn(names_of(interface_laws())));

}  // namespace
}  // namespace dda
