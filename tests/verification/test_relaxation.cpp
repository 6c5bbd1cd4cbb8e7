// Dynamic relaxation finds what the direct solver finds, and says when nothing is to be found.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "studies/dda/case/simulation.hpp"
#include "verification/chain.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

/// What Newton's tolerance leaves of a displacement, the soft modes of a beam being some 1e4 times softer
/// than its blocks.
constexpr double near = 1e-6;

std::string increments(const std::string& solver, double increment) {
  return fmt::format("{{control: {{type: load_increments, increment: {}, solver: {}}}", increment, solver);
}

/// A simply supported beam 200 × 50 × 100 under a force at midspan; every joint is brittle.
std::string beam(const std::string& subdivision, const std::string& path) {
  return fmt::format(R"(
scene:
  regions:
    - {{name: beam, material: concrete, vertices: [[0, 0], [200, 0], [200, 50], [0, 50]]}}
  subdivision: {}
thickness: 100
materials: {{concrete: {{type: linear_elastic, young_modulus: 27500, poisson_ratio: 0.2}}}}
interfaces:
  joints: {{between: [concrete, concrete], law: {{type: mohr_coulomb, tensile_strength: 3, cohesion: 5, friction_angle: 37}}}}
supports:
  left: {{at: [0, 0], fix: xy}}
  right: {{at: [200, 0], fix: y}}
stages:
  - {{loads: [{{type: point_load, at: [100, 50], force: [0, -1]}}]}}
gauges:
  deflection: {{type: displacement, at: [100, 0], direction: [0, -1]}}
path: {}
)",
                     subdivision, path);
}

class RelaxedBeam : public testing::TestWithParam<std::string> {};

/// Below the first crack an increment is an elastic problem: K0 d = λ f.
TEST_P(RelaxedBeam, IsTheDirectSolutionWhileElastic) {
  const std::string deck = beam(GetParam(), increments("dynamic_relaxation", 0.3) + ", stop: {steps: 2}}");
  const Trace trace = follow(deck);
  ASSERT_EQ(trace.points.size(), 2u) << trace.ending.reason;
  const std::vector<double> direct = intact_response(Structure(deck).equilibrium);
  const auto size = static_cast<Eigen::Index>(direct.size());
  const Eigen::Map<const Eigen::VectorXd> unit(direct.data(), size);
  for (const Traced& at : trace.points) {
    const Eigen::Map<const Eigen::VectorXd> found(at.state.d.data(), size);
    EXPECT_GT(at.state.load_factor, 0);
    EXPECT_NEAR((found - at.state.load_factor * unit).norm() / (at.state.load_factor * unit.norm()), 0, near);
    EXPECT_NEAR(at.work / at.stored, 1, near);
  }
}

INSTANTIATE_TEST_SUITE_P(Blocks, RelaxedBeam,
                         testing::Values("{type: grid, columns: 16, rows: 4}",
                                         "{type: voronoi, blocks: 50, seed: 3}"));

void expect_same(const Trace& found, const Trace& expected, const std::string& gauge) {
  ASSERT_EQ(found.points.size(), expected.points.size()) << found.ending.reason;
  const Traced& peak = expected.points[expected.peak()];
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    const Traced &a = found.points[i], &b = expected.points[i];
    EXPECT_NEAR(a.state.load_factor, b.state.load_factor, near * peak.state.load_factor) << i;
    EXPECT_NEAR(a.gauges.at(gauge), b.gauges.at(gauge), near * std::abs(peak.gauges.at(gauge))) << i;
    EXPECT_NEAR(a.dissipated, b.dissipated, near * peak.work) << i;
  }
  EXPECT_EQ(found.ending.kind, expected.ending.kind);
}

/// A reinforced beam, so to speak: bonded blocks below a brittle body, which cracks in many increments.
std::string two_layers(const std::string& path) {
  return fmt::format(R"(
scene:
  regions:
    - {{name: body, material: concrete, vertices: [[0, 10], [200, 10], [200, 50], [0, 50]]}}
    - {{name: bar, material: steel, vertices: [[0, 0], [200, 0], [200, 10], [0, 10]]}}
  subdivision: {{type: grid, columns: 10, rows: 2}}
thickness: 100
materials:
  concrete: {{type: linear_elastic, young_modulus: 27500, poisson_ratio: 0}}
  steel: {{type: linear_elastic, young_modulus: 27500, poisson_ratio: 0}}
interfaces:
  cracks: {{between: [concrete, concrete], law: {{type: mohr_coulomb, tensile_strength: 3, cohesion: 50}}}}
supports:
  left: {{at: [0, 0], fix: xy}}
  right: {{at: [200, 0], fix: y}}
stages:
  - {{loads: [{{type: point_load, at: [90, 50], force: [0, -1]}}]}}
gauges:
  deflection: {{type: displacement, at: [90, 50], direction: [0, -1]}}
path: {}
)",
                     path);
}

TEST(RelaxedRelease, CracksAsTheDirectSolverSays) {
  const std::string rest = ", stop: {steps: 12}}";
  const Trace relaxed = follow(two_layers(increments("dynamic_relaxation", 0.3) + rest));
  const Trace direct = follow(two_layers(increments("newton", 0.3) + rest));
  ASSERT_EQ(direct.points.size(), 12u) << direct.ending.reason;
  EXPECT_GT(direct.last().dissipated, 0) << "or nothing would have been released";
  expect_same(relaxed, direct, "deflection");
}

/// The chain whose first joint breaks while the second goes on, up to the strength of that.
TEST(RelaxedRelease, PassesTheFirstReleaseAndStopsBelowFailure) {
  const auto chain = [](const std::string& solver) {
    return Chain{.laws = {"{type: mohr_coulomb, tensile_strength: 1, cohesion: 100}",
                          "{type: mohr_coulomb, tensile_strength: 3, cohesion: 100}"},
                 .treatment = "{type: penalty, stiffness: 1000}",
                 .held_left = false,
                 .springs = {{0, 1e6}, {1, 1e6}},
                 .path = increments(solver, 0.07) + "}"}
        .deck();
  };
  const Trace relaxed = follow(chain("dynamic_relaxation"));
  expect_same(relaxed, follow(chain("newton")), "x1");
  EXPECT_EQ(relaxed.ending.kind, Ending::Kind::stopped_early);
  EXPECT_THAT(relaxed.ending.reason, testing::StartsWith("failure: no equilibrium beyond a load factor of"));
  EXPECT_THAT(relaxed.ending.reason, testing::HasSubstr("dynamic relaxation did not come to rest"));
}

TEST(RelaxedRelease, NothingIsAcceptedThatHasNotComeToRest) {
  const Trace trace = follow(beam("{type: grid, columns: 16, rows: 4}",
                                  increments("{type: dynamic_relaxation, max_iterations: 3}", 0.3) + "}"));
  EXPECT_TRUE(trace.points.empty());
  EXPECT_EQ(trace.ending.kind, Ending::Kind::stopped_early);
  EXPECT_THAT(trace.ending.reason, testing::HasSubstr("did not come to rest in 3 iterations"));
}

/// Cohesive cracks are followed up to the load that they can carry, ft A.
TEST(RelaxedRelease, CohesiveBarReachesItsStrength) {
  const Trace trace =
      follow(Chain{.laws = {"{type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}"},
                   .path = increments("dynamic_relaxation", 0.3) + "}"}
                 .deck());
  ASSERT_FALSE(trace.points.empty());
  EXPECT_NEAR(trace.last().state.load_factor, 3, 3 * 2e-4);
  EXPECT_LE(trace.last().state.load_factor, 3 * (1 + near));
  EXPECT_EQ(trace.ending.kind, Ending::Kind::stopped_early);
}

}  // namespace
}  // namespace dda::verification
