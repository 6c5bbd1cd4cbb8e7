#include <gtest/gtest.h>

#include "models/kinematics/first_order.hpp"

namespace dda {
namespace {

TEST(FirstOrder, LinearFieldIsReproduced) {
  Mat2 g;
  g << 0.1, -0.3, 0.7, 0.2;
  const Vec2 a(1, 2), x(0.4, -1.1);
  Vec6 d;
  d << a, (g(1, 0) - g(0, 1)) / 2, g(0, 0), g(1, 1), g(0, 1) + g(1, 0);
  EXPECT_LT((displacement_rows(x) * d - (a + g * x)).norm(), 1e-15);
  EXPECT_EQ(strain_rows() * d, Vec3(0.1, 0.2, g(0, 1) + g(1, 0)));
}

TEST(FirstOrder, TractionIsTheStressVectorInLocalComponents) {
  const Vec3 stress(3, -1, 2);
  EXPECT_EQ(traction_rows(Vec2(1, 0)) * stress, Vec2(3, 2));
  EXPECT_EQ(traction_rows(Vec2(0, 1)) * stress, Vec2(-1, -2));
  const Vec2 n(0.6, 0.8), s(-0.8, 0.6);
  Mat2 tensor;
  tensor << 3, 2, 2, -1;
  EXPECT_LT((traction_rows(n) * stress - Vec2(n.dot(tensor * n), s.dot(tensor * n))).norm(), 1e-15);
}

}  // namespace
}  // namespace dda
