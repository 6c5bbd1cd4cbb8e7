#include <gtest/gtest.h>

#include <cmath>

#include "models/interface/law.hpp"
#include "models/interface/softening/softening_shape.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

struct ShapeCase {
  std::string name;
  std::shared_ptr<const SofteningShape> shape;
};

void PrintTo(const ShapeCase& at, std::ostream* out) { *out << at.name; }

std::vector<ShapeCase> shapes() {
  return {{"linear", piecewise_linear_shape({{0, 1}, {2, 0}})},
          {"petersson", piecewise_linear_shape({{0, 1}, {0.8, 1.0 / 3}, {3.6, 0}})},
          {"plateau", piecewise_linear_shape({{0, 1}, {0.5, 1}, {1.5, 0}})},
          {"four pieces", piecewise_linear_shape({{0, 1}, {0.4, 0.5}, {1, 0.4}, {2, 0.2}, {3.3, 0}})},
          {"exponential", exponential_shape()}};
}

class Shape : public testing::TestWithParam<ShapeCase> {
 protected:
  static constexpr int draws = 400;
  const SofteningShape& shape_ = *GetParam().shape;
  /// Where a tail without an end is cut: exp(−40) is below round-off.
  double end() const { return std::isfinite(shape_.end()) ? shape_.end() : 40; }
  double somewhere() { return random_.between(0, 1) * std::min(end(), 8.0); }
  /// ∫₀^ω g by Simpson's rule; kinks cost less than the square of a step.
  double area(double omega) const {
    constexpr int steps = 20000;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      sum += shape_.value(omega * i / steps) + 4 * shape_.value(omega * (i + 0.5) / steps) +
             shape_.value(omega * (i + 1) / steps);
    return sum * omega / steps / 6;
  }
  Random random_{31};
};

TEST_P(Shape, StartsAtOneAndEnclosesOne) {
  EXPECT_EQ(shape_.value(0), 1);
  EXPECT_NEAR(area(end()), 1, 1e-7);
  EXPECT_NEAR(shape_.value(end()), 0, 1e-16);
  EXPECT_NEAR(shape_.value(2 * end()), 0, 1e-30);
}

TEST_P(Shape, FallsAsItsSlopeSays) {
  double steepest = 0;
  for (int i = 0; i < draws; ++i) {
    const double step = 1e-6, omega = i == 0 ? step : somewhere();
    const double slope = (shape_.value(omega + step) - shape_.value(omega - step)) / (2 * step);
    EXPECT_NEAR(shape_.slope(omega), slope, 1e-8);
    EXPECT_LE(slope, 1e-12);
    steepest = std::max(steepest, -slope);
  }
  EXPECT_LE(steepest, shape_.steepest() * (1 + 1e-8));
  EXPECT_GE(steepest, shape_.steepest() * 0.95);
}

TEST_P(Shape, SpendsWhatUnloadingDoesNotGiveBack) {
  for (int i = 0; i < 20; ++i) {
    const double omega = somewhere();
    EXPECT_NEAR(shape_.spent(omega), area(omega) - 0.5 * omega * shape_.value(omega), 1e-7);
  }
  EXPECT_NEAR(shape_.spent(1.5 * end()), 1, 1e-12);
}

TEST_P(Shape, InvertsTheTrialOpening) {
  for (int i = 0; i < draws; ++i) {
    const double omega = somewhere(), scale = random_.between(0.1, 10);
    const double kappa0 = random_.between(0.05, 0.98) * scale / shape_.steepest();
    const double opening = scale * omega + kappa0 * shape_.value(omega);
    EXPECT_NEAR(shape_.at_trial_opening(opening, scale, kappa0), omega, 1e-11 * (1 + omega));
  }
  EXPECT_NEAR(shape_.at_trial_opening(0.1, 1, 0.1), 0, 1e-15) << "at initiation nothing is open";
}

TEST_P(Shape, InvertsTheCompliance) {
  for (int i = 0; i < draws; ++i) {
    const double omega = 0.99 * somewhere(), ratio = std::exp(random_.between(-2, 2));
    const double other = shape_.at_same_compliance(omega, ratio);
    EXPECT_NEAR(other * shape_.value(omega), ratio * omega * shape_.value(other),
                1e-12 * (1 + ratio) * (1 + omega + other));
    EXPECT_NEAR(shape_.at_same_compliance(other, 1 / ratio), omega, 1e-11 * (1 + omega));
  }
  EXPECT_EQ(shape_.at_same_compliance(0, 3), 0);
}

INSTANTIATE_TEST_SUITE_P(All, Shape, testing::ValuesIn(shapes()));

/// By default the knee is at 0.8 Gf/ft and ft/3, the end at 3.6 Gf/ft (Petersson).
TEST(BilinearSoftening, IsPeterssonsCurveByDefault) {
  constexpr double ft = 3, gf = 0.1, k = 1000;
  const auto law =
      interface_laws()
          .choose(parse_yaml("{type: bilinear_softening, tensile_strength: 3, fracture_energy: 0.1}", "d"))
          .make();
  const auto traction = [&](double q) { return law->respond({q, 0}, {}, k).traction.x(); };
  const double knee = 0.8 * gf / ft, end = 3.6 * gf / ft;
  EXPECT_NEAR(traction(ft / k), ft, 1e-12);
  EXPECT_NEAR(traction(knee + ft / 3 / k), ft / 3, 1e-12);
  EXPECT_NEAR(law->rupture_kappa(k), end, 1e-15);
  EXPECT_NEAR(law->steepest_slope(), 5.0 / 6 * ft * ft / gf, 1e-11);
  for (const double share : {0.2, 0.7}) {
    const double first = ft * (1 - share * 2 / 3), second = ft / 3 * (1 - share);
    EXPECT_NEAR(traction(share * knee + first / k), first, 1e-12);
    EXPECT_NEAR(traction(knee + share * (end - knee) + second / k), second, 1e-12);
  }
}

/// knee = 2 a (1 − s), end = (2 − knee)/s.
TEST(BilinearSoftening, TakesAnotherKnee) {
  const auto law =
      interface_laws()
          .choose(parse_yaml("{type: bilinear_softening, tensile_strength: 2, fracture_energy: 1, "
                             "knee_stress: 0.25, initial_share: 0.5}",
                             "d"))
          .make();
  constexpr double k = 100, knee = 0.75 / 2, end = (2 - 0.75) / 0.25 / 2;
  EXPECT_NEAR(law->respond({knee + 0.5 / k, 0}, {}, k).traction.x(), 0.5, 1e-12);
  EXPECT_NEAR(law->rupture_kappa(k), end, 1e-12);
  EXPECT_NEAR(law->spending({end, 0}, {}, k).value, 1, 1e-12);
}

}  // namespace
}  // namespace dda
