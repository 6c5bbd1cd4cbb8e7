#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/law_case.hpp"
#include "support/law_of.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

/// What a point does between two shares of its release; ft = 2, c = 3, φ = 30°, residual 20°; k = 100.
class ReleasedPoint : public testing::Test {
 protected:
  static constexpr double ft = 2, c = 3, k = 100, pressure = 4;
  const double tan_ = tangent_of(30), residual_ = tangent_of(20);
  const std::unique_ptr<InterfaceLaw> law_ = law_of(
      "{type: mohr_coulomb, tensile_strength: 2, cohesion: 3, friction_angle: 30, residual_friction_angle: "
      "20}");
  const double strength_ = c + pressure * tan_;
  const Vec2 sheared_{-pressure / k, strength_ / k};

  double limit(double share) const { return share * strength_ + (1 - share) * pressure * residual_; }
  Vec2 traction(const Vec2& q, const History& h) const { return law_->respond(q, h, k).traction; }
  History moved(const Vec2& q, const History& h, double share) const {
    return law_->accept(q, law_->release(opening(h), h, k, share), k);
  }
  double slip(const History& h) const { return remembered_number(*law_, h, "slip"); }
  static Vec2 opening(const InterfaceLaw& law, History h) {
    const auto q = remembered(law, h, "opening");
    return {q[0], q[1]};
  }
  Vec2 opening(const History& h) const { return opening(*law_, h); }
  History failed(const Vec2& q) const { return law_->accept(q, {}, k); }

  /// A point that fails anywhere on its strength, and is partly released.
  History begun(Random& random) const {
    Vec2 q(random.between(-8, 2) / k, 0);
    q.y() = (random.coin() ? 1 : -1) * (c - k * q.x() * tan_) / k;
    if (random.coin()) q = {ft / k, random.between(-1.8, 1.8) / k};
    return moved(q, failed(q), random.between(0.5, 1));
  }
};

TEST_F(ReleasedPoint, ReturnsElasticallyWithinALimitThatShrinks) {
  const History half = moved(sheared_, failed(sheared_), 0.5);
  EXPECT_NEAR(traction(sheared_, half).y(), limit(0.5), 1e-12);
  const Vec2 back(0, -0.5 * limit(0.5) / k);
  EXPECT_NEAR(traction(sheared_ + back, half).y(), 0.5 * limit(0.5), 1e-12) << "with the stiffness k";
  const History turned = moved(sheared_ + back, half, 0.5);
  EXPECT_EQ(turned.dissipated, half.dissipated) << "nothing slides";
  EXPECT_NEAR(traction(sheared_ + 10 * back, half).y(), -limit(0.5), 1e-12)
      << "slides back at the same limit";
  const History less = moved(sheared_ + back, turned, 0.4);
  EXPECT_NEAR(traction(sheared_ + back, less).y(), 0.5 * limit(0.5), 1e-12) << "not yet at its limit";
  EXPECT_EQ(less.dissipated, turned.dissipated);
  const History none = moved(sheared_ + back, less, 0);
  EXPECT_NEAR(traction(sheared_ + back, none).y(), std::min(0.5 * limit(0.5), limit(0)), 1e-12);
}

TEST_F(ReleasedPoint, SlidesUnderTheMeanOfItsLimits) {
  const History begun = failed(sheared_), half = moved(sheared_, begun, 0.5);
  EXPECT_NEAR(half.dissipated, 0.5 * (limit(1) + limit(0.5)) * (limit(1) - limit(0.5)) / k, 1e-13);
  EXPECT_NEAR(slip(half), (limit(1) - limit(0.5)) / k, 1e-14);
  EXPECT_NEAR(law_->stored(sheared_, half, k), (pressure * pressure + std::pow(limit(0.5), 2)) / (2 * k),
              1e-13);
}

TEST_F(ReleasedPoint, IsTornWhereItReachesItsTensileStrengthMeanwhile) {
  const History half = moved(sheared_, failed(sheared_), 0.5);
  const Vec2 open(ft / k, slip(half) + 0.2 * c / k);
  const History torn = moved(open, half, 0.5);
  EXPECT_TRUE(torn.loading);
  const Vec2 before = traction(open, torn);
  EXPECT_NEAR(before.x(), ft, 1e-12);
  const History begun = law_->release(open, torn, k, 1);
  EXPECT_TRUE(law_->is_broken(begun, k));
  EXPECT_LT((traction(open, begun) - before).norm(), 1e-12) << "without a jump";
  const History less = moved(open, torn, 0.25);
  EXPECT_NEAR(traction(open, less).x(), 0.25 * ft, 1e-12);
  EXPECT_NEAR(traction(open - Vec2(0.1 * ft / k, 0), less).x(), 0.15 * ft, 1e-12) << "elastic return";
  EXPECT_EQ(traction(open - Vec2(0.5 * ft / k, 0), less).x(), 0) << "it has opened by more";
  EXPECT_NEAR(traction({-0.01, open.y()}, less).x(), -0.01 * k, 1e-12) << "contact";
}

TEST_F(ReleasedPoint, NeverGainsEnergy) {
  Random random{7};
  for (int i = 0; i < 2000; ++i) {
    History h = begun(random);
    for (double share = h.share; share > 0;) {
      share = std::max(0.0, share - random.between(0, 0.3));
      const Vec2 q = opening(h) + random.point(0.05);
      const History next = moved(Vec2(std::min(q.x(), ft / k), q.y()), h, share);
      EXPECT_GE(next.dissipated, h.dissipated);
      h = next;
    }
    const History slid = law_->accept(opening(h) + random.point(0.05), h, k);
    EXPECT_GE(slid.dissipated, h.dissipated);
  }
}

/// Without friction the limits run straight along a straight step: in one step as much as in many.
TEST_F(ReleasedPoint, SpendsAsMuchInOneStepAsInMany) {
  const auto law = law_of("{type: mohr_coulomb, tensile_strength: 2, cohesion: 3}");
  Random random{11};
  for (const Vec2& failure : {Vec2(-0.01, 0.03), Vec2(0.02, 0.01)})
    for (int i = 0; i < 50; ++i) {
      const auto go = [&](const Vec2& q, const History& h, double share) {
        return law->accept(q, law->release(opening(*law, h), h, k, share), k);
      };
      const History start = go(failure, law->accept(failure, {}, k), 0.8);
      const Vec2 to(failure.x() * random.between(0.2, 1), failure.y() + random.between(-0.08, 0.08));
      const double share = random.between(0.1, 0.8);
      History many = start;
      constexpr int steps = 500;
      for (int s = 1; s <= steps; ++s) {
        const double x = static_cast<double>(s) / steps;
        many = go((1 - x) * failure + x * to, many, (1 - x) * 0.8 + x * share);
      }
      const History once = go(to, start, share);
      EXPECT_NEAR(once.dissipated, many.dissipated, 1e-12);
      EXPECT_LT((law->respond(to, once, k).traction - law->respond(to, many, k).traction).norm(), 1e-10);
    }
}

TEST_F(ReleasedPoint, DerivativesAreThoseOfDifferences) {
  Random random{3};
  constexpr double step = 1e-8;
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const History start = begun(random),
                  h = law_->release(opening(start), start, k, random.between(0.1, 0.5));
    const Vec2 q = opening(start) + random.point(0.05);
    const auto spent = [&](const Vec2& at) { return law_->spending(at, h, k).value; };
    Mat2 tangent, one_sided;
    Vec2 gradient, rough;
    for (int j = 0; j < 2; ++j) {
      const Vec2 e = step * Vec2::Unit(j);
      tangent.col(j) = (traction(q + e, h) - traction(q - e, h)) / (2 * step);
      one_sided.col(j) = (traction(q + e, h) - traction(q, h)) / step;
      gradient[j] = (spent(q + e) - spent(q - e)) / (2 * step);
      rough[j] = (spent(q + e) - spent(q)) / step;
    }
    if ((tangent - one_sided).norm() > 1e-3 * k || (gradient - rough).norm() > 1e-3) continue;  // a corner
    ++compared;
    EXPECT_LT((law_->respond(q, h, k).tangent - tangent).norm(), 1e-5 * k);
    EXPECT_LT((law_->spending(q, h, k).gradient - gradient).norm(), 1e-5) << q.transpose();
  }
  EXPECT_GT(compared, 900);
}

}  // namespace
}  // namespace dda
