#include <gmock/gmock.h>

#include "continuation/course/path_parameters.hpp"
#include "continuation/detour/dead_load.hpp"
#include "continuation/state/acceptance.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

/// A panel of 2 × 2 blocks pulled to the right under its dead load [MPa]: the lower half of the joint in its
/// middle bears 1 MPa, the upper half 10 MPa, and both lose their strength at once.
std::string panel_deck(double dead) {
  return R"(
scene:
  regions:
    - {name: a, material: concrete, vertices: [[0, 0], [50, 0], [50, 50], [0, 50]]}
    - {name: b, material: concrete, vertices: [[50, 0], [100, 0], [100, 50], [50, 50]]}
    - {name: c, material: concrete, vertices: [[0, 50], [50, 50], [50, 100], [0, 100]]}
    - {name: d, material: concrete, vertices: [[50, 50], [100, 50], [100, 100], [50, 100]]}
  curves: {weak: [[50, 0], [50, 50]], strong: [[50, 50], [50, 100]]}
  boundaries: {left: [[0, 0], [0, 100]], right: [[100, 0], [100, 100]]}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0}}
interfaces:
  weak: {law: {type: mohr_coulomb, tensile_strength: 1, cohesion: 5, friction_angle: 30}}
  strong: {law: {type: mohr_coulomb, tensile_strength: 10, cohesion: 50, friction_angle: 30}}
supports:
  wall: {boundary: left, fix: xy}
  guide_b: {at: [75, 25], fix: rotation}
  guide_d: {at: [75, 75], fix: rotation}
stages:
  - {name: dead, loads: [{type: edge_traction, boundary: right, traction: [)" +
         std::to_string(dead) + R"(, 0]}]}
  - {name: live, loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]}
)";
}

struct Panel {
  explicit Panel(double dead)
      : structure(panel_deck(dead)),
        equilibrium(structure.equilibrium()),
        parameters(path_schema().read(parse_yaml("{}", "path.yaml"))),
        system(equilibrium, parameters.linear, parameters.update),
        stepper(system, parameters),
        walker(stepper) {}

  bool is_broken(std::size_t p) const {
    const InterfacePoint& point = equilibrium.point(p);
    return point.law->is_broken(system.history()[p], point.stiffness);
  }

  Structure structure;
  Equilibrium equilibrium;
  PathParameters parameters;
  System system;
  Stepper stepper;
  Walker walker;
};

TEST(DeadLoad, CrackedOnTheWayIsCarriedByTheRest) {
  Panel panel(1.5);
  EXPECT_EQ(apply_full_stage(panel.walker), "");
  EXPECT_EQ(panel.walker.state().load_factor, 1);
  const auto laws = panel.system.laws_at(panel.walker.state().d, 1);
  EXPECT_LE(strength_excess(panel.system, panel.system.history(), *laws).value, 1e-4);
  EXPECT_LE(panel.system.excess_residual(panel.walker.state()), 1e-9);
  double carried = 0;
  for (std::size_t p = 0; p < panel.equilibrium.num_active(); ++p) {
    const bool is_below = panel.equilibrium.point(p).x.y() < 50;
    EXPECT_EQ(panel.is_broken(p), is_below);
    if (!is_below) carried += panel.equilibrium.point(p).weight * laws->traction[p].x();
  }
  EXPECT_NEAR(carried, 1.5 * 100 * 100, 1e-2);
}

TEST(DeadLoad, BelowTheStrengthCracksNothing) {
  Panel panel(0.9);
  EXPECT_EQ(apply_full_stage(panel.walker), "");
  EXPECT_EQ(panel.walker.here().dissipated, 0);
  EXPECT_EQ(panel.walker.effort().accepted, 1);
}

TEST(DeadLoad, ThatNothingCarriesSaysWhereItIsLost) {
  Panel panel(8);
  EXPECT_THAT(apply_full_stage(panel.walker),
              testing::AllOf(testing::StartsWith("strength is lost at a load factor of 0."),
                             testing::HasSubstr("only weak springs hold")));
  EXPECT_LT(panel.walker.state().load_factor, 1);
}

}  // namespace
}  // namespace dda
