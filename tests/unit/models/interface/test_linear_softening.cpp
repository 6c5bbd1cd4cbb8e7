#include <gtest/gtest.h>

#include "support/law_case.hpp"

namespace dda {
namespace {

/// ft = 3, Gf = 0.1: w_c = 2 Gf/ft = 1/15; k = 200, so that κ0 = 0.015.
class LinearSoftening : public testing::Test {
 protected:
  static constexpr double ft = 3, gf = 0.1, wc = 2 * gf / ft, k = 200, k0 = ft / k;
  static std::unique_ptr<InterfaceLaw> make(const std::string& more = "") {
    return interface_laws()
        .choose(parse_yaml("{type: linear_softening, tensile_strength: 3, fracture_energy: 0.1" + more + "}",
                           "d"))
        .make();
  }
  /// That of a point which has opened as far as κ.
  History opened(double kappa, bool loading = false) const {
    History out;
    remembered(*law_, out, "kappa").front() = kappa;
    out.loading = loading;
    return out;
  }
  const std::unique_ptr<InterfaceLaw> law_ = make();
};

TEST_F(LinearSoftening, NumbersOfTheLaw) {
  EXPECT_DOUBLE_EQ(law_->initial_kappa(k), k0);
  EXPECT_DOUBLE_EQ(law_->rupture_kappa(k), wc);
  EXPECT_DOUBLE_EQ(law_->steepest_slope(), ft * ft / (2 * gf));
  EXPECT_EQ(law_->shear_weight(), 1);
  EXPECT_TRUE(law_->can_crack());
}

TEST_F(LinearSoftening, PhysicalOpeningFollowsTheStraightLine) {
  for (const double share : {0.1, 0.5, 0.9}) {
    const double kappa = k0 + share * (wc - k0);
    const double t = law_->respond({kappa, 0}, {}, k).traction.x();
    const double w = kappa - t / k;
    EXPECT_NEAR(t, ft * (1 - w / wc), 1e-13);
    EXPECT_NEAR(w, share * wc, 1e-15);
    EXPECT_NEAR(law_->spending({kappa, 0}, {}, k).value, share * gf, 1e-15);
    EXPECT_NEAR(law_->damage(opened(kappa), k), 1 - t / (k * kappa), 1e-14);
  }
}

/// An event is met to 1e-10 of κ: what acceptance flags there as loading must spend and soften, or the path
/// has no direction in which anything cracks.
TEST_F(LinearSoftening, WhatIsFlaggedOnItsSurfaceLoads) {
  for (const double below : {0.0, 2e-11, 9e-11}) {
    const Vec2 q(k0 * (1 - below), 0);
    const History h = law_->accept(q, {}, k);
    EXPECT_TRUE(h.loading) << below;
    EXPECT_GT(law_->spending(q, h, k).gradient.x(), 0) << below;
    EXPECT_LT(law_->respond(q, h, k).tangent(0, 0), 0) << below;
  }
}

TEST_F(LinearSoftening, UnloadsToTheOriginAndReloads) {
  const History h = opened(0.03);
  const double envelope = law_->respond({0.03, 0}, {}, k).traction.x();
  for (const double share : {0.9, 0.3, 0.01})
    EXPECT_NEAR(law_->respond({share * 0.03, 0}, h, k).traction.x(), share * envelope, 1e-14);
}

TEST_F(LinearSoftening, ClosedCrackKeepsTheFullStiffnessAndNoShear) {
  const Response closed = law_->respond({-0.01, 0.02}, opened(wc), k);
  EXPECT_DOUBLE_EQ(closed.traction.x(), -0.01 * k);
  EXPECT_NEAR(closed.traction.y(), 0, 1e-15);
}

TEST_F(LinearSoftening, ShearWeightEntersOpeningAndStiffness) {
  const auto weighted = make(", shear_weight: 0.5");
  EXPECT_DOUBLE_EQ(weighted->equivalent_opening({0.03, 0.08}, {}, k), 0.05);
  EXPECT_DOUBLE_EQ(weighted->equivalent_opening({-0.03, 0.08}, {}, k), 0.04);
  EXPECT_DOUBLE_EQ(weighted->respond({0, 0.01}, {}, k).traction.y(), 0.25 * k * 0.01);
}

/// On its surface a point has two tangents; the flag of the history chooses.
TEST_F(LinearSoftening, FlagChoosesTheSideOfTheSurface) {
  const double kappa = 0.03, t = law_->respond({kappa, 0}, {}, k).traction.x();
  EXPECT_NEAR(law_->respond({kappa, 0}, opened(kappa), k).tangent(0, 0), t / kappa, 1e-12);
  EXPECT_NEAR(law_->respond({kappa, 0}, opened(kappa, true), k).tangent(0, 0), -ft / wc / (1 - k0 / wc),
              1e-11);
  EXPECT_NEAR(law_->respond({kappa, 0}, opened(kappa, true), k).tangent(1, 1), t / kappa, 1e-12);
}

TEST_F(LinearSoftening, ReleasedPointCarriesNothing) {
  const Response released = law_->respond({2 * wc, 1}, {}, k);
  EXPECT_EQ(released.traction.norm(), 0);
  EXPECT_EQ(released.tangent.norm(), 0);
}

}  // namespace
}  // namespace dda
