#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/interface/law.hpp"

namespace dda {
namespace {

constexpr double ft = 3, cohesion = 4.5, beta = cohesion / ft, gf = 0.1, gf_shear = 0.25;

/// Every softening law with modes of unlike energy; numbers above, the rest as given.
class Softening : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<InterfaceLaw> make(const std::string& more, double shear_energy = gf_shear) const {
    const std::string text = fmt::format(
        "{{type: {}, tensile_strength: {}, fracture_energy: {}, shear_fracture_energy: {}, cohesion: {}{}}}",
        GetParam(), ft, gf, shear_energy, cohesion, more);
    return interface_laws().choose(parse_yaml(text, "d")).make();
  }
  /// ∫ t·dw along the straight opening q = x · mode, w = q − P⁻¹ t, far beyond rupture.
  static double crack_work(const InterfaceLaw& law, const Vec2& mode, double k) {
    constexpr int steps = 40000;
    const Vec2 p(k, k * beta * beta);
    const double first = law.initial_kappa(k) / Vec2(mode.x(), beta * mode.y()).norm(),
                 last = first + 12 * gf_shear;
    double work = 0;
    Vec2 t = law.respond(first * mode, {}, k).traction, w = first * mode - t.cwiseQuotient(p);
    for (int i = 1; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      const Vec2 q = (first + share * share * (last - first)) * mode;
      const Vec2 next = law.respond(q, {}, k).traction, opened = q - next.cwiseQuotient(p);
      work += 0.5 * (t + next).dot(opened - w);
      t = next;
      w = opened;
    }
    return work;
  }
  static constexpr double quadrature = 1e-6;
};

TEST_P(Softening, PureModesEncloseTheirEnergiesAtAnyStiffness) {
  for (const double shear_energy : {gf_shear, 0.6 * gf})
    for (const double k : {300.0, 2000.0}) {
      const auto law = make("", shear_energy);
      ASSERT_GT(k, law->steepest_slope());
      EXPECT_NEAR(crack_work(*law, {1, 0}, k) / gf, 1, quadrature) << k;
      EXPECT_NEAR(crack_work(*law, {0, 1}, k) / shear_energy, 1, quadrature) << k;
      EXPECT_NEAR(crack_work(*law, {0, -1}, k) / shear_energy, 1, quadrature) << k;
    }
}

TEST_P(Softening, StrengthsOfPureModesAreTensileStrengthAndCohesion) {
  const auto law = make("");
  const double k = 500, k0 = law->initial_kappa(k);
  EXPECT_NEAR(law->respond({k0, 0}, {}, k).traction.x(), ft, 1e-12);
  EXPECT_NEAR(law->respond({0, k0 / beta}, {}, k).traction.y(), cohesion, 1e-12);
}

/// Gf(M) = Gf + (Gf_II − Gf) M^η, M the share of sliding in the work.
TEST_P(Softening, ProportionalOpeningSpendsTheInterpolatedEnergy) {
  for (const double eta : {1.0, 1.8})
    for (const double mixity : {0.2, 0.5, 0.85}) {
      const auto law = make(fmt::format(", mixed_mode_exponent: {}", eta));
      const Vec2 mode(std::sqrt(1 - mixity), std::sqrt(mixity) / beta);
      const double expected = gf + (gf_shear - gf) * std::pow(mixity, eta);
      EXPECT_NEAR(crack_work(*law, mode, 700) / expected, 1, quadrature) << eta << ", " << mixity;
      EXPECT_NEAR(law->spending(12 * gf_shear * mode, {}, 700).value / expected, 1, 1e-12) << "in one step";
    }
}

/// Turning a crack from one mode to another never makes it stiffer.
TEST_P(Softening, ChangingTheModeNeverHeals) {
  const auto law = make("");
  constexpr double k = 500;
  History h = law->accept({4 * law->initial_kappa(k), 0}, {}, k);
  const double damage = law->damage(h, k);
  for (int i = 0; i <= 100; ++i) {
    const double angle = i * 0.005 * std::acos(-1.0);
    const Vec2 q = 4 * law->initial_kappa(k) * Vec2(std::cos(angle), std::sin(angle) / beta);
    h = law->accept(q, h, k);
    EXPECT_GE(law->damage(h, k), damage);
    const double secant = 1 - law->damage(h, k);
    EXPECT_NEAR(law->respond(q, h, k).traction.x(), secant * k * q.x(), 1e-10 * k * q.norm());
  }
}

/// Opened, unloaded and sheared until it breaks: work = spent at second order, also where growth begins anew.
TEST_P(Softening, GrowingAgainInAnotherModeBalancesAtSecondOrder) {
  const auto law = make("");
  constexpr double k = 500;
  const auto imbalance = [&](int substeps) {
    History h;
    double work = 0;
    const Vec2 opened(3 * law->initial_kappa(k), 0), sheared(0, 3.37 * law->initial_kappa(k));
    for (const auto& [from, to] : {std::pair(Vec2(0, 0), opened), std::pair(opened, sheared)})
      for (int i = 0; i < substeps; ++i) {
        const Vec2 step = (to - from) / substeps, a = from + i * step, b = a + step;
        const auto t = [&](const Vec2& q) { return law->respond(q, h, k).traction; };
        work += (t(a) + 4 * t(0.5 * (a + b)) + t(b)).dot(step) / 6;
        h = law->accept(b, h, k);
      }
    return std::abs(work - law->stored(sheared, h, k) - h.dissipated) / gf;
  };
  double coarse = 0, fine = 0;
  for (const int substeps : {97, 103, 109, 127}) {
    coarse += imbalance(substeps);
    fine += imbalance(8 * substeps);
  }
  constexpr double kinks = 4.0 / 800 / 800;  // one in each of the four, wherever in its substep
  EXPECT_LT(fine, std::max(coarse / 30, kinks)) << coarse << " to " << fine;
}

/// Under pressure p a joint starts to slide at c + p tan φ and ends at p tan φ; the rest of it is Gf_II.
TEST_P(Softening, ClosedJointSlidesAtItsMohrCoulombStrength) {
  const auto law = make(", friction_angle: 35");
  const double k = 600, slope = std::tan(35 * std::acos(-1.0) / 180), pressure = 7;
  const double shear = beta * beta * k;
  History h;
  double peak = 0, last = 0, work = 0;
  constexpr int steps = 40000;
  const double far = (cohesion + slope * pressure) / shear + 12 * gf_shear;
  for (int i = 1; i <= steps; ++i) {
    const Vec2 q(-pressure / k, far * i / steps);
    const double t = law->respond(q, h, k).traction.y();
    work += 0.5 * (t + last) * far / steps;
    peak = std::max(peak, t);
    last = t;
    h = law->accept(q, h, k);
  }
  EXPECT_NEAR(peak, cohesion + slope * pressure, 5 * shear * far / steps);
  EXPECT_NEAR(last, slope * pressure, 1e-10);
  const double stored = 0.5 * std::pow(slope * pressure, 2) / shear, slid = far - slope * pressure / shear;
  EXPECT_NEAR(work, gf_shear + slope * pressure * slid + stored, 1e-6 * work);
  EXPECT_NEAR(h.dissipated, gf_shear + slope * pressure * slid, 1e-6 * work);
  const History before = law->accept({-pressure / k, 0.999 * (cohesion + slope * pressure) / shear}, {}, k);
  EXPECT_EQ(law->damage(before, k), 0) << "below its strength it only sticks";
  EXPECT_GT(
      law->damage(law->accept({-pressure / k, 1.001 * (cohesion + slope * pressure) / shear}, {}, k), k), 0);
}

INSTANTIATE_TEST_SUITE_P(Laws, Softening,
                         testing::Values("linear_softening", "bilinear_softening", "exponential_softening"));

}  // namespace
}  // namespace dda
