#include <gtest/gtest.h>

#include "continuation/detour/staggered.hpp"
#include "tests/unit/continuation/on_path.hpp"

namespace dda {
namespace {

void follow(Bar& bar) {
  for ([[maybe_unused]] const Point& point : bar.path()) {
  }
}

std::optional<Settled> staggered(Bar& bar, double elongation) {
  return staggered_at_gauge(bar.stepper(), bar.walker().state(), {bar.gauge(), elongation});
}

/// u = σ L/E + w with σ = ft (1 − w/w_c), w_c = 2 Gf/ft, wherever the bar does not snap back.
TEST(Staggered, EndsOnTheLawWhereTheGaugeIsHeld) {
  Bar bar(100, "stop: {steps: 2}");
  follow(bar);
  System& system = bar.system();
  const double before = system.dissipated(system.history());
  const double ft = 3, wc = 0.2 / 3, compliance = 100.0 / 30000;
  for (const double elongation : {0.012, 0.03, 0.06}) {
    const auto found = staggered(bar, elongation);
    ASSERT_TRUE(found) << elongation;
    const double w = (elongation - ft * compliance) / (1 - ft * compliance / wc);
    EXPECT_NEAR(found->state.load_factor, ft * (1 - w / wc), 1e-9) << elongation;
    EXPECT_NEAR(found->state.value(bar.gauge()), elongation, 1e-12);
    EXPECT_EQ(system.dissipated(system.history()), before) << "the system itself has not moved";
  }
}

/// A bar of more than 2 E Gf/ft² breaks where its elongation is held: all of Gf is spent, and none of what it stored is left.
TEST(Staggered, BreaksWhatSnapsBack) {
  Bar bar(2000, "stop: {steps: 2}");
  follow(bar);
  const auto found = staggered(bar, 1.01 * bar.elongation());
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->state.load_factor, 0, 1e-6);
  const double spent = 0.1 * 100 * 100;
  EXPECT_NEAR(bar.system().dissipated(found->history) / spent, 1, 1e-9);
}

}  // namespace
}  // namespace dda
