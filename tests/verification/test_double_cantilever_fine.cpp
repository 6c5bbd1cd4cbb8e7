// Double cantilever F2 on blocks small enough for its order.
#include <gtest/gtest.h>

#include "verification/double_cantilever.hpp"

namespace dda::verification {
namespace {

TEST(FineDoubleCantilever, MomentConvergesToTheClosedFormAtSecondOrder) {
  const double coarse = DoubleCantilever{.rows = 8}.mean_plateau() - 1;
  const double fine = DoubleCantilever{.rows = 16}.mean_plateau() - 1;
  EXPECT_NEAR(fine, 0, 0.005);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

}  // namespace
}  // namespace dda::verification
