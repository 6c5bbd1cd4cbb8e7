#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/interface/law.hpp"
#include "support/law_of.hpp"

namespace dda {
namespace {

TEST(ContactFriction, SticksThenSlidesThenSticksAgain) {
  const auto law = law_of("{type: friction, friction_angle: 30}");
  constexpr double k = 50, gap = -0.2;
  const double limit = tangent_of(30) * k * 0.2;
  History h;
  EXPECT_NEAR(law->respond({gap, 0.1}, h, k).traction.y(), k * 0.1, 1e-13);
  h = law->accept({gap, 0.1}, h, k);
  EXPECT_FALSE(h.sliding);
  EXPECT_EQ(h.dissipated, 0);
  h = law->accept({gap, 0.5}, h, k);
  EXPECT_TRUE(h.sliding);
  EXPECT_NEAR(law->respond({gap, 0.5}, h, k).traction.y(), limit, 1e-13);
  EXPECT_NEAR(law->respond({gap, 0.4}, h, k).traction.y(), limit - 0.1 * k, 1e-13)
      << "sticks on the way back";
  EXPECT_NEAR(law->respond({gap, -0.4}, h, k).traction.y(), -limit, 1e-13);
  EXPECT_EQ(law->respond({0.01, 0.5}, h, k).traction.norm(), 0) << "open";
}

TEST(ContactFriction, ClosesAgainWhereItMeets) {
  const auto law = law_of("{type: friction, friction_angle: 30}");
  History h = law->accept({-0.1, 0}, {}, 50);
  h = law->accept({0.3, 0.8}, h, 50);
  const double m = std::tan(std::numbers::pi / 6), onset = 0.1 * m / (0.8 + 0.4 * m);
  EXPECT_NEAR(h.dissipated, 50 * m * 0.5 * (0.1 - 0.4 * onset) * 0.2, 1e-12) << "until the sides part";
  const Vec2 t = law->respond({-0.2, 0.8}, h, 50).traction;
  EXPECT_NEAR(t.x(), -10, 1e-12);
  EXPECT_NEAR(t.y(), 0, 1e-12) << "the sliding while open is forgotten";
}

TEST(ContactFriction, WithoutAngleSlidesFreely) {
  const auto law = law_of("{type: friction}");
  const Response closed = law->respond({-0.2, 3}, {}, 50);
  EXPECT_LT((closed.traction - Vec2(-10, 0)).norm(), 1e-12);
  EXPECT_LT((closed.tangent - Mat2(Vec2(50, 0).asDiagonal())).norm(), 1e-12);
}

/// ft = 2, c = 3, φ = 30°, residual 20°; k = 100.
class MohrCoulomb : public testing::Test {
 protected:
  static constexpr double ft = 2, c = 3, k = 100;
  const double tan_ = tangent_of(30), residual_ = tangent_of(20);
  const std::unique_ptr<InterfaceLaw> law_ = law_of(
      "{type: mohr_coulomb, tensile_strength: 2, cohesion: 3, friction_angle: 30, residual_friction_angle: "
      "20}");

  Vec2 traction(const Vec2& q, const History& h) const { return law_->respond(q, h, k).traction; }
  double utilisation(const Vec2& q, const History& h = {}) const {
    return law_->equivalent_opening(q, h, k) / law_->kappa(h, k);
  }
  History after(const Vec2& q, History h, double share) const {
    return law_->accept(q, law_->release(q, h, k, share), k);
  }
};

TEST_F(MohrCoulomb, StrengthIsTheTensionCutOffAndTheFrictionLine) {
  EXPECT_NEAR(utilisation({ft / k, 0}), 1, 1e-14);
  for (const double normal : {-8.0, -1.0, 0.5})
    for (const double sign : {1.0, -1.0})
      EXPECT_NEAR(utilisation({normal / k, sign * (c - normal * tan_) / k}), 1, 1e-14) << normal;
  EXPECT_EQ(utilisation({-1, 0}), 0);
  EXPECT_TRUE(law_->releases_at_once());
}

TEST_F(MohrCoulomb, TensionIsReleasedToNothingAndClosesAgain) {
  const Vec2 q(ft / k, 0.004);
  History h = law_->accept(q, {}, k);
  EXPECT_TRUE(h.loading);
  const Vec2 held = traction(q, h);
  for (const double share : {0.75, 0.25, 0.0}) {
    h = after(q, h, share);
    EXPECT_EQ(law_->damage(h, k), 1);
    EXPECT_LT((traction(q, h) - share * held).norm(), 1e-13);
    EXPECT_NEAR(h.dissipated, (1 - share * share) * held.squaredNorm() / (2 * k), 1e-13) << "of the spring";
  }
  EXPECT_TRUE(law_->is_broken(h, k));
  EXPECT_EQ(traction({3, 1}, h).norm(), 0);
  h = law_->accept({0.1, 0.5}, h, k);
  const Vec2 closed = traction({-0.05, 0.5 + 1}, h);
  EXPECT_NEAR(closed.x(), -0.05 * k, 1e-12);
  EXPECT_NEAR(closed.y(), residual_ * 0.05 * k, 1e-12);
}

TEST_F(MohrCoulomb, SlidingIsReleasedToResidualFriction) {
  for (const double sign : {1.0, -1.0}) {
    const double pressure = 4;
    const Vec2 q(-pressure / k, sign * (c + pressure * tan_) / k);
    History h = law_->accept(q, {}, k);
    EXPECT_TRUE(h.loading);
    for (const double share : {0.5, 0.0}) {
      h = after(q, h, share);
      EXPECT_EQ(law_->damage(h, k), 0.5);
      EXPECT_NEAR(traction(q, h).x(), -pressure, 1e-12);
      EXPECT_NEAR(traction(q, h).y(),
                  sign * (share * (c + pressure * tan_) + (1 - share) * pressure * residual_), 1e-12);
    }
    EXPECT_EQ(h.share, 0);
    EXPECT_FALSE(law_->is_broken(h, k)) << "it still has its limited tension";
    EXPECT_NEAR(traction({q.x(), q.y() + sign}, h).y(), sign * pressure * residual_, 1e-12)
        << "goes on sliding";
    EXPECT_NEAR(traction({2 * q.x(), q.y() + sign}, h).y(), sign * 2 * pressure * residual_, 1e-12);
    EXPECT_LT((traction({0.5 * ft / k, q.y()}, h) - Vec2(0.5 * ft, 0)).norm(), 1e-12)
        << "limited tension, no shear";
    EXPECT_NEAR(utilisation({ft / k, q.y()}, h), 1, 1e-14);
    h = after({ft / k, q.y()}, law_->accept({ft / k, q.y()}, h, k), 0);
    EXPECT_EQ(law_->damage(h, k), 1);
    EXPECT_EQ(traction({ft / k, q.y()}, h).norm(), 0);
  }
}

/// A joint torn open that closes before the release ends is held by friction from where it has slid to.
TEST_F(MohrCoulomb, TensionReleasedUnderPressureEndsWithoutAJump) {
  const Vec2 torn(ft / k, -0.004), closed(-0.05, -0.01);
  const History nearly = after(closed, after(torn, law_->accept(torn, {}, k), 0.5), 1e-9);
  const History h = law_->release(closed, nearly, k, 0);
  const Vec2 now = traction(closed, h);
  EXPECT_LT((now - traction(closed, nearly)).norm(), 1e-8);
  EXPECT_NEAR(now.y(), -k * 0.008, 1e-10) << "of 0.01, but for what slid while half was lost";
  const double slid = 1e-4;
  for (const double sign : {1.0, -1.0})
    EXPECT_NEAR(traction(closed + Vec2(0, sign * slid), h).y(), now.y() + sign * k * slid, 1e-10) << "stuck";
}

/// Of what is released in full: the joint that the law itself is, wherever it is opened, closed and slid.
TEST_F(MohrCoulomb, LeavesTheContactThatItResponds) {
  const Vec2 shear(-0.04, (c + 4 * tan_) / k), tension(ft / k, 0.004);
  for (const Vec2& failed : {shear, tension}) {
    const History begun = law_->accept(failed, {}, k), partly = after(failed, begun, 0.5);
    EXPECT_FALSE(law_->contact(begun, k));
    EXPECT_FALSE(law_->contact(partly, k));
    const History h = after(failed, partly, 0);
    const auto contact = law_->contact(h, k);
    ASSERT_TRUE(contact);
    for (const double normal : {-0.3, -0.02, 0.01})
      for (const double sliding : {-0.2, -0.001, 0.001, 0.2}) {
        const Vec2 q(normal, contact->slip + sliding), t = traction(q, h);
        const double limit = contact->coefficient * std::max(-normal, 0.0);
        EXPECT_NEAR(t.x(), (normal < 0 ? contact->closed : contact->open) * normal, 1e-12);
        EXPECT_NEAR(t.y(), contact->shear * q.y() + contact->friction * std::clamp(sliding, -limit, limit),
                    1e-12);
      }
  }
}

/// While it is released a point's opening stays in the direction that the release holds.
TEST_F(MohrCoulomb, HoldsTheDirectionInWhichItFails) {
  const History intact;
  const Vec2 shear(-0.01, -(c + tan_) / k), tension(ft / k, 0);
  EXPECT_EQ(law_->held_direction(shear, law_->release(shear, intact, k, 0.5)), Vec2(0, -1));
  EXPECT_EQ(law_->held_direction(tension, law_->release(tension, intact, k, 0.5)), Vec2(1, 0));
}

}  // namespace
}  // namespace dda
