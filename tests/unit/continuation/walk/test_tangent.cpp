#include <gtest/gtest.h>

#include <cmath>

#include "continuation/course/path_parameters.hpp"
#include "continuation/detour/dead_load.hpp"
#include "support/cracked.hpp"

namespace dda {
namespace {

/// A guided bar whose joint a displaced end has opened as far as half its traction, 1.5 of 3 MPa, in the
/// first stage; in the second that end stays held and the middle is loaded by `live` [MPa].
std::string cracked_bar(double live) {
  return R"(
scene:
  regions:
    - {name: a, material: concrete, vertices: [[0, 0], [50, 0], [50, 100], [0, 100]]}
    - {name: b, material: concrete, vertices: [[50, 0], [100, 0], [100, 100], [50, 100]]}
  curves: {crack: [[50, 0], [50, 100]]}
  boundaries: {left: [[0, 0], [0, 100]], right: [[100, 0], [100, 100]]}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0}}
interfaces:
  crack: {points: midpoint, law: {type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}}
supports:
  wall: {boundary: left, fix: x}
  guide_a: {at: [25, 50], fix: y}
  guide_b: {at: [75, 50], fix: y}
  turn_a: {at: [25, 50], fix: rotation}
  turn_b: {at: [75, 50], fix: rotation}
stages:
  - {name: dead, loads: [{type: prescribed_displacement, at: [100, 50], direction: [1, 0], displacement: 0.03833333}]}
  - {name: live, loads: [{type: edge_traction, boundary: right, traction: [)" +
         std::to_string(live) + R"(, 0]}]}
)";
}

/// The bar at the start of its second stage, its crack flagged as loading.
struct CrackedBar {
  explicit CrackedBar(double live)
      : structure(cracked_bar(live)),
        equilibrium(structure.equilibrium()),
        parameters(path_schema().read(parse_yaml("{}", "path.yaml"))),
        system(equilibrium, parameters.linear, parameters.update),
        stepper(system, parameters),
        walker(stepper) {
    failure = apply_full_stage(walker);
    loads = system.history()[0].loading;
    walker.begin_stage(1);
  }

  Structure structure;
  Equilibrium equilibrium;
  PathParameters parameters;
  System system;
  Stepper stepper;
  Walker walker;
  std::string failure;
  bool loads = false;  ///< the crack, at the end of the first stage
};

/// Following the crack as the arriving tangent has it would take the load backwards, because that spends
/// energy.
TEST(StartingTangent, UnloadsTheCrackThatItsLoadCloses) {
  CrackedBar bar(-1);
  ASSERT_EQ(bar.failure, "");
  ASSERT_TRUE(bar.loads);
  const Tangent& arriving = bar.walker.here().arriving;
  ASSERT_TRUE(arriving.dissipates);
  ASSERT_LT(arriving.load_factor, 0);
  const Tangent& leaving = bar.walker.leaving();
  EXPECT_EQ(leaving.load_factor, 1);
  EXPECT_FALSE(leaving.dissipates);
  EXPECT_LT(leaving.opening[0].x(), 0);
  EXPECT_FALSE(bar.system.history()[0].loading);
}

TEST(StartingTangent, GoesOnWithTheCrackThatItsLoadOpens) {
  CrackedBar bar(1);
  ASSERT_EQ(bar.failure, "");
  const Tangent& leaving = bar.walker.leaving();
  EXPECT_GT(leaving.load_factor, 0);
  EXPECT_TRUE(leaving.dissipates);
  EXPECT_GT(leaving.opening[0].x(), 0);
  EXPECT_TRUE(bar.system.history()[0].loading);
}

/// Rate of the equivalent opening of a point along a tangent.
double rate_of(const CrackedSystem& at, System& system, std::size_t p, const Tangent& along) {
  const auto laws = system.laws_at(at.state());
  const InterfacePoint& point = system.equilibrium().point(p);
  return point.law->opening_gradient(laws->opening[p], system.history()[p], point.stiffness)
      .dot(along.opening[p]);
}

/// Of many points that stand on their damage surface those go on that the growing load opens, and no others.
TEST(StartingTangent, FlagsAreThoseOfItsRates) {
  int went_on = 0, unloaded = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CrackedSystem at(square_deck(), seed);
    System& system = at.system();
    system.set_history(system.next_history(at.state()));
    const std::vector<History> before = system.history();
    const Tangent found = starting_tangent(system, at.state());
    ASSERT_FALSE(found.d.empty());
    EXPECT_GT(found.load_factor, 0) << "seed " << seed;
    double fastest = 0;
    for (std::size_t p = 0; p < before.size(); ++p)
      if (before[p].loading) fastest = std::max(fastest, std::abs(rate_of(at, system, p, found)));
    for (std::size_t p = 0; p < before.size(); ++p) {
      if (!before[p].loading) continue;
      const bool goes_on = system.history()[p].loading;
      ++(goes_on ? went_on : unloaded);
      EXPECT_GE((goes_on ? 1 : -1) * rate_of(at, system, p, found), -1e-9 * fastest)
          << "seed " << seed << ", point " << p;
    }
  }
  EXPECT_GT(went_on, 0);
  EXPECT_GT(unloaded, 0);
}

}  // namespace
}  // namespace dda
