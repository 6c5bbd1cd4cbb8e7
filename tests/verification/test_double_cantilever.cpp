// Double cantilever F2 under pure moments: M = √(Gf b E I) for any cohesive law.
#include <gtest/gtest.h>

#include "verification/double_cantilever.hpp"

namespace dda::verification {
namespace {

TEST(DoubleCantilever, CrackGrowsAtTheMomentOfTheClosedForm) {
  const double coarse = DoubleCantilever{.rows = 4}.mean_plateau() - 1;
  const double fine = DoubleCantilever{.rows = 8}.mean_plateau() - 1;
  EXPECT_NEAR(fine, 0, 0.02);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

TEST(DoubleCantilever, StrengthDoesNotMatter) {
  EXPECT_NEAR((DoubleCantilever{.strength = 2.0}.mean_plateau()), 1, 0.02);
}

TEST(DoubleCantilever, MomentGoesWithTheRootOfTheFractureEnergy) {
  EXPECT_NEAR((DoubleCantilever{.energy = 0.003}.mean_plateau()), 1, 0.02);
}

/// With a sixteenth of the blocks, an eighth of the unknowns.
TEST(DoubleCantilever, BlocksOfSecondOrderNeedAnEighthOfTheUnknowns) {
  const double first = DoubleCantilever{.rows = 8}.mean_plateau() - 1,
               second = DoubleCantilever{.rows = 2, .kinematics = "second_order"}.mean_plateau() - 1;
  EXPECT_NEAR(second, 0, 0.01);
  EXPECT_LT(std::abs(second), std::abs(first));
}

}  // namespace
}  // namespace dda::verification
