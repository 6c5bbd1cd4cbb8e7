#include <gtest/gtest.h>

#include <cmath>

#include "continuation/reach.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

std::unique_ptr<InterfaceLaw> softening() {
  return interface_laws()
      .choose(parse_yaml(
          "{type: linear_softening, tensile_strength: 3, fracture_energy: 0.1, shear_weight: 0.7}", "d"))
      .make();
}

TEST(Reach, ProportionalOpeningIsScaled) {
  EXPECT_DOUBLE_EQ(reach(*softening(), {0, 0}, {0.02, 0}, 0.05), 2.5);
  EXPECT_DOUBLE_EQ(reach(*softening(), {0, 0}, {-3, 0.1}, 0.07), 1) << "closing does not count, sliding does";
}

TEST(Reach, NeverReached) {
  EXPECT_TRUE(std::isinf(reach(*softening(), {0, 0}, {-1, 0}, 0.05)));
  EXPECT_TRUE(std::isinf(reach(*softening(), {0, 0}, {0, 0}, 0.05)));
  EXPECT_TRUE(std::isinf(reach(*softening(), {0, 0}, {1, 0}, INFINITY)));
}

TEST(Reach, LandsOnKappaAndStaysBeyondIt) {
  const auto law = softening();
  Random random(8);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const Vec2 a = random.point(0.02), b = random.point(1);
    const double kappa = random.between(0.03, 0.06);
    const double x = reach(*law, a, b, kappa);
    if (!std::isfinite(x)) continue;
    ++found;
    EXPECT_NEAR(law->equivalent_opening(a + x * b) / kappa, 1, 1e-13);
    EXPECT_GT(law->equivalent_opening(a + 1.01 * x * b), kappa);
    EXPECT_LT(law->equivalent_opening(a + 0.99 * x * b), kappa);
  }
  EXPECT_GT(found, 200);
}

}  // namespace
}  // namespace dda
