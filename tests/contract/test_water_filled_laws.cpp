#include "contract/law_contract.hpp"
#include "support/law_case.hpp"

namespace dda {
namespace {

class WaterFilledLaws : public LawContract {
 protected:
  /// A law and the same with water in its crack; k bears both.
  struct Pair {
    LawCase dry, wet;
    double pressure, opening;
  };
  Pair next_pair() {
    const bool with_optional = ++pairs_ % 2 == 0;
    LawCase dry = random_law(GetParam(), random_, with_optional);
    const double gain = dry.law->widening(0, dry.k)->gain, opening = random_.between(0.3, 1) * dry.last;
    const double weight = dry.law->shear_weight(),
                 spare = dry.k * std::min(1.0, weight * weight) - dry.law->steepest_slope();
    const double pressure = random_.between(0.1, 0.8) * spare * opening / gain;
    std::shared_ptr<const InterfaceLaw> solid = interface_laws().choose(GetParam(), dry.parameters).make();
    LawCase wet{std::make_unique<WaterFilledLaw>(solid, pressure, opening),
                dry.parameters,
                dry.k,
                dry.first,
                dry.last,
                true};
    return {std::move(dry), std::move(wet), pressure, opening};
  }
  int pairs_ = 0;
};

/// The solid answers the opening that the water adds, and the water takes its pressure from the traction.
TEST_P(WaterFilledLaws, TheSolidSeesItsOwnTraction) {
  int filled = 0;
  for (int c = 0; c < cases; ++c) {
    const Pair at = next_pair();
    History wet, dry;
    for (int i = 0; i < draws; ++i) {
      const Vec2 q = random_opening(at.wet);
      const Vec2 traction = at.wet.traction(q, wet);
      wet = at.wet.law->accept(q, wet, at.wet.k);
      const double p = at.wet.law->water_pressure(wet, at.wet.k);
      const Vec2 seen(q.x() + p / at.wet.k, q.y());
      EXPECT_LT((at.dry.traction(seen, dry) - Vec2(traction.x() + p, traction.y())).norm(),
                1e-9 * at.wet.stiff() * at.wet.last);
      dry = at.dry.law->accept(seen, dry, at.dry.k);
      EXPECT_NEAR(wet.dissipated, dry.dissipated,
                  1e-9 * (dry.dissipated + at.dry.k * at.dry.first * at.dry.first));
      const double opening = at.dry.law->widening(at.dry.law->kappa(dry, at.dry.k), at.dry.k)->opening;
      EXPECT_NEAR(p / at.pressure, std::min(opening / at.opening, 1.0), 1e-9);
      filled += p == at.pressure;
    }
  }
  EXPECT_GE(filled, draws);
}

/// A crack of pure opening carries its law's traction less the pressure.
TEST_P(WaterFilledLaws, PureOpening) {
  for (int c = 0; c < cases; ++c) {
    const Pair at = next_pair();
    for (const double share : {0.1, 0.4, 0.8, 1.3}) {
      const double w = share * at.dry.last;
      double low = 0, high = w + at.dry.first;  // of the solid's trial opening, w + t/k
      for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (middle - at.dry.traction({middle, 0}, {}).x() / at.dry.k < w ? low : high) = middle;
      }
      const double of_solid = at.dry.traction({high, 0}, {}).x(),
                   p = at.pressure * std::min(w / at.opening, 1.0);
      EXPECT_NEAR(at.wet.traction({high - p / at.wet.k, 0}, {}).x(), of_solid - p,
                  1e-9 * at.wet.k * at.wet.last);
    }
  }
}

TEST_P(WaterFilledLaws, WhatIsFilledStaysFilledWhereItCloses) {
  const Pair at = next_pair();
  const History open = at.wet.law->accept({3 * at.wet.last, 0}, {}, at.wet.k);
  const History closed = at.wet.law->accept({-at.wet.last, 0}, open, at.wet.k);
  EXPECT_EQ(at.wet.law->water_pressure(closed, at.wet.k), at.pressure);
  EXPECT_NEAR(at.wet.traction({-at.wet.last, 0}, closed).x(), -at.wet.k * at.wet.last,
              1e-9 * at.wet.k * at.wet.last);
}

INSTANTIATE_TEST_SUITE_P(Registry, WaterFilledLaws,
                         testing::Values("linear_softening", "bilinear_softening", "exponential_softening"),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
