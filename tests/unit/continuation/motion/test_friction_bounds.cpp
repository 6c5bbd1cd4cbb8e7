#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "continuation/motion/step/friction_bounds.hpp"

namespace dda {
namespace {

/// Two contacts whose bounds follow from each other's until they stick: μ N = min(c + A b, s).
struct Jammed {
  Vec2 c;
  Mat2 a;
  double stuck = 1e9;

  std::vector<FrictionBound> asked(const Vec2& b) const {
    const Vec2 now = (c + a * b).cwiseMin(stuck);
    return {{{.body = 1}, now[0]}, {{.body = 2}, now[1]}};
  }
  Vec2 solution() const { return (Mat2::Identity() - a).inverse() * c; }
};

Vec2 settled(const Jammed& jammed, int passes) {
  FrictionBounds bounds;
  Vec2 b = jammed.c;
  for (int i = 0; i < passes; ++i) {
    std::vector<FrictionBound> asked = jammed.asked(b);
    bounds.relax(asked);
    b = {asked[0].force, asked[1].force};
  }
  return b;
}

TEST(FrictionBounds, SettleWherePlainPassesGoToAndFroForEver) {
  const Jammed jammed{{30, 20}, (Mat2() << -0.9, -0.5, -0.3, -1.1).finished()};
  const Vec2 exact = jammed.solution(), found = settled(jammed, 20);
  EXPECT_NEAR(found[0], exact[0], 1e-3 * exact.norm());
  EXPECT_NEAR(found[1], exact[1], 1e-3 * exact.norm());
}

TEST(FrictionBounds, GrowToWhereWhatJamsSticks) {
  const Jammed jammed{{0.3, 20}, (Mat2() << 1.02, 0, 0, 0.5).finished(), 5e4};
  const Vec2 found = settled(jammed, 40);
  EXPECT_NEAR(found[0], 5e4, 50);
  EXPECT_NEAR(found[1], 40, 0.4);
}

/// Three bodies that wedge each other: μ N = b* + A (b − b*), A a rotation about (1, 1, 1) and 1.3 times as long.
TEST(FrictionBounds, SettleWhereResidualsTurn) {
  const Eigen::Vector3d exact(400, 500, 450), axis = Eigen::Vector3d::Ones().normalized();
  const Eigen::Matrix3d a = 1.3 * Eigen::AngleAxisd(1.9, axis).toRotationMatrix();
  FrictionBounds bounds;
  Eigen::Vector3d b(420, 490, 430);
  for (int pass = 0; pass < 25; ++pass) {
    std::vector<FrictionBound> asked;
    for (std::uint32_t i = 0; i < 3; ++i)
      asked.push_back({{.body = i + 1}, exact[i] + a.row(i).dot(b - exact)});
    bounds.relax(asked);
    for (std::uint32_t i = 0; i < 3; ++i) b[i] = asked[i].force;
  }
  EXPECT_LT((b - exact).norm(), 1e-6 * exact.norm());
}

TEST(FrictionBounds, ForgetWhatIsGone) {
  const Jammed jammed{{30, 20}, Mat2::Zero()};
  FrictionBounds bounds;
  std::vector<FrictionBound> asked = jammed.asked(Vec2::Zero());
  bounds.relax(asked);
  asked.pop_back();
  EXPECT_DOUBLE_EQ(bounds.change(asked), 20.0 / 30);
  bounds.relax(asked);
  EXPECT_EQ(bounds.change(asked), 0);
}

TEST(FrictionBounds, AreTakenAsTheyAreWhereNothingIsJammed) {
  const Jammed jammed{{30, 20}, Mat2::Zero()};
  EXPECT_EQ(settled(jammed, 1), jammed.c);
  EXPECT_EQ(settled(jammed, 5), jammed.c);
}

TEST(FrictionBounds, TellHowFarTheForcesAreFromThem) {
  const Jammed jammed{{30, 20}, Mat2::Zero()};
  FrictionBounds bounds;
  std::vector<FrictionBound> asked = jammed.asked(Vec2::Zero());
  EXPECT_EQ(bounds.change(asked), 1);
  bounds.relax(asked);
  asked[1].force = 25;
  EXPECT_DOUBLE_EQ(bounds.change(asked), 5.0 / 55);
}

}  // namespace
}  // namespace dda
