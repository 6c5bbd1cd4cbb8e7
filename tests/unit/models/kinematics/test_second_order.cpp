#include <gtest/gtest.h>

#include "meshing/geometry/polygon.hpp"
#include "models/kinematics/second_order.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

constexpr double size = 2.5;

Vec6 random_gradient(Random& random) {
  Vec6 out;
  for (double& value : out) value = random.between(-1, 1);
  return out;
}

/// The displacement is quadratic, so that central differences of any width are exact.
Mat2 displacement_gradient(const Vec6& g, const Vec2& x) {
  constexpr double step = 0.5;
  Mat2 out;
  for (int i = 0; i < 2; ++i) {
    const Vec2 aside = step * Vec2::Unit(i);
    out.col(i) = (gradient_displacement_rows(x + aside, size) - gradient_displacement_rows(x - aside, size)) *
                 g / (2 * step);
  }
  return out;
}

TEST(SecondOrder, StrainAndRotationAreDerivativesOfTheDisplacement) {
  Random random(7);
  for (int i = 0; i < 20; ++i) {
    const Vec6 g = random_gradient(random);
    const Vec2 x = random.point(3);
    const Mat2 du = displacement_gradient(g, x);
    EXPECT_LT((gradient_strain_rows(x, size) * g - Vec3(du(0, 0), du(1, 1), du(0, 1) + du(1, 0))).norm(),
              1e-13);
    EXPECT_NEAR(gradient_rotation_row(x, size).dot(g), (du(1, 0) - du(0, 1)) / 2, 1e-13);
  }
}

TEST(SecondOrder, IsStillAtTheCentroidButForItsCurvature) {
  EXPECT_TRUE(gradient_displacement_rows(Vec2::Zero(), size).isZero(0));
  EXPECT_TRUE(gradient_strain_rows(Vec2::Zero(), size).isZero(0));
  EXPECT_TRUE(gradient_rotation_row(Vec2::Zero(), size).isZero(0));
}

/// ½ g·K g of a rectangle, against ∫ ½ ε·C ε dA by two Gauss points in each direction, exact for linear strains.
TEST(SecondOrder, StiffnessIsThatOfTheStrainEnergy) {
  Random random(8);
  const double a = 1.5, b = 0.75;
  const Moments m = moments({{{-a, -b}, {a, -b}, {a, b}, {-a, b}}});
  Mat3 c;
  c << 4, 1, 0.3, 1, 3, 0.2, 0.3, 0.2, 2;
  const Mat6 k = gradient_stiffness(c, m.second, m.area);
  for (int i = 0; i < 20; ++i) {
    const Vec6 g = random_gradient(random);
    double twice = 0;
    for (const double x : {-a / std::sqrt(3.0), a / std::sqrt(3.0)})
      for (const double y : {-b / std::sqrt(3.0), b / std::sqrt(3.0)}) {
        const Vec3 strain = gradient_strain_rows({x, y}, std::sqrt(m.area)) * g;
        twice += m.area / 4 * strain.dot(c * strain);
      }
    EXPECT_NEAR(g.dot(k * g), twice, 1e-13);
  }
}

}  // namespace
}  // namespace dda
