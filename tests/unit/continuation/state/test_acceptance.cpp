#include <gmock/gmock.h>

#include "continuation/state/acceptance.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

using testing::HasSubstr;

/// Two blocks 100 × 100 side by side, pulled apart by 1 MPa: 10 000 N.
constexpr auto pulled = R"(
scene:
  regions:
    - {name: a, material: m, vertices: [[0, 0], [100, 0], [100, 100], [0, 100]]}
    - {name: b, material: m, vertices: [[100, 0], [200, 0], [200, 100], [100, 100]]}
  curves: {crack: [[100, 0], [100, 100]]}
  boundaries: {left: [[0, 0], [0, 100]], right: [[200, 0], [200, 100]]}
thickness: 100
materials: {m: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0}}
interfaces: {crack: {treatment: {type: penalty, stiffness: 1000}, law: {type: mohr_coulomb, tensile_strength: 3, cohesion: 3}}}
supports: {wall: {boundary: left, fix: xy}}
stages: [{loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}]
)";

class Acceptance : public testing::Test {
 protected:
  Acceptance()
      : structure_(pulled),
        equilibrium_(structure_.equilibrium()),
        system_(equilibrium_, direct_solvers().choose("cholmod"), LinearSystem::Update::low_rank) {}

  /// The second block moved to the right.
  State moved(double by, double load_factor) const {
    std::vector<double> d(equilibrium_.num_unknowns(), 0.0);
    d[6] = by;
    return {std::move(d), load_factor};
  }
  Structure structure_;
  Equilibrium equilibrium_;
  System system_;
};

TEST_F(Acceptance, WhatMovesFartherThanTheStructureIsLargeIsHeldByNothing) {
  const SoundnessLimits limits{.size = equilibrium_.extent(), .largest_load = 0};
  const auto objection = [&](double by) {
    return objection_to(holding_of(system_, moved(by, 1)), limits, equilibrium_);
  };
  EXPECT_EQ(objection(0.1), "");
  EXPECT_THAT(objection(1e6), HasSubstr("block 1 at (100, 50)"));
  EXPECT_THAT(objection(std::numeric_limits<double>::quiet_NaN()), HasSubstr("weak springs"));
}

TEST_F(Acceptance, WeakSpringsBearNothingOfTheLoad) {
  const double unit = equilibrium_.weak_stiffness(), load = 1e4;
  const auto objection = [&](double share, double load_factor, double largest) {
    return objection_to(holding_of(system_, moved(share * load / unit, load_factor)), {1e12, largest},
                        equilibrium_);
  };
  EXPECT_EQ(objection(9e-4, 1, load), "");
  EXPECT_THAT(objection(1.1e-3, 1, load), HasSubstr("they would bear 1.1e-03 of the load"));
  EXPECT_EQ(objection(9e-7, 0, load), "") << "where the load has gone, a share of the largest counts";
  EXPECT_NE(objection(1.1e-6, 0, load), "");
}

TEST_F(Acceptance, NoPointStandsBeyondItsStrength) {
  const auto objection = [&](double share) {
    const State at = moved(share * 3 / 1000.0, 1);
    const LawValues laws = system_.laws(at);
    return objection_to(strength_excess(system_, system_.history(), laws), system_);
  };
  EXPECT_EQ(objection(0.5), "");
  EXPECT_EQ(objection(1 + 9e-5), "");
  EXPECT_THAT(objection(1 + 2e-4), HasSubstr("on 'crack' stands 2.0e-04 beyond its strength"));
}

}  // namespace
}  // namespace dda
