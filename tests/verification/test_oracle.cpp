// The fast path against the plain one that factorises every tangent anew: the same equilibria.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/support.hpp"

namespace dda::verification {
namespace {

const std::vector<double> landings{0.002, 0.005, 0.01, 0.02, 0.04};

struct OracleCase {
  std::string subdivision, law, treatment;
};

void PrintTo(const OracleCase& c, std::ostream* out) {
  *out << c.subdivision << ", " << c.law << ", " << c.treatment;
}

std::string beam(const OracleCase& of, const std::string& update) {
  return fmt::format(R"(
scene:
  regions:
    - {{material: concrete, vertices: [[0, 0], [200, 0], [200, 50], [0, 50]]}}
  slits: {{notch: [[100, 0], [100, 20]]}}
  subdivision: {0}
thickness: 100
materials: {{concrete: {{type: linear_elastic, young_modulus: 30000, poisson_ratio: 0.2}}}}
interfaces:
  any:
    between: [concrete, concrete]
    treatment: {2}
    law: {{{1}, tensile_strength: 3, fracture_energy: 0.05}}
supports: {{left: {{at: [0, 0], fix: xy}}, right: {{at: [200, 0], fix: y}}}}
stages:
  - {{loads: [{{type: point_load, at: [100, 50], force: [0, -1]}}]}}
gauges:
  cmod: {{type: relative_displacement, from: [100, 0], to: [100, 0], from_inside: [99.99, 0.01], to_inside: [100.01, 0.01], direction: [1, 0]}}
record: {{at: {{cmod: [{3}]}}}}
path: {{update: {4}, stop: {{load_below: 0.1}}}}
)",
                     of.subdivision, of.law, of.treatment, fmt::join(landings, ", "), update);
}

class Oracle : public testing::TestWithParam<OracleCase> {};

TEST_P(Oracle, UpdatedAndRefactorisedPathsMeetAtEveryLanding) {
  const Trace fast = follow(beam(GetParam(), "low_rank")), plain = follow(beam(GetParam(), "refactorise"));
  ASSERT_EQ(fast.ending.kind, Ending::Kind::goal_reached) << fast.ending.reason;
  ASSERT_EQ(plain.ending.kind, Ending::Kind::goal_reached) << plain.ending.reason;
  const double peak = plain.points[plain.peak()].load;
  EXPECT_NEAR(fast.points[fast.peak()].load, peak, 1e-4 * peak);  // to what a peak is bracketed
  const auto landed_at = [](const Trace& trace, double opening) {
    return std::ranges::find_if(trace.points, [&](const Traced& point) {
      return std::abs(point.gauges.at("cmod") - opening) <= 1e-9 * opening;
    });
  };
  for (const double opening : landings) {
    const auto a = landed_at(fast, opening), b = landed_at(plain, opening);
    if (b == plain.points.end()) continue;  // the path ended before
    ASSERT_NE(a, fast.points.end()) << opening;
    EXPECT_NEAR(a->load, b->load, 1e-9 * peak) << opening;
    EXPECT_NEAR(a->dissipated, b->dissipated, 1e-9 * plain.last().dissipated) << opening;
  }
  EXPECT_NE(landed_at(plain, landings.front()), plain.points.end());
}

INSTANTIATE_TEST_SUITE_P(
    Beams, Oracle,
    testing::Values(
        OracleCase{"{type: voronoi, blocks: 60, seed: 1}", "type: linear_softening", "consistent"},
        OracleCase{"{type: voronoi, blocks: 60, seed: 1}", "type: exponential_softening", "consistent"},
        OracleCase{"{type: voronoi, blocks: 60, seed: 1}",
                   "type: bilinear_softening, cohesion: 5, friction_angle: 37", "penalty"},
        OracleCase{"{type: grid, columns: 16, rows: 5, shape: triangles}", "type: linear_softening",
                   "consistent"},
        OracleCase{"{type: grid, columns: 16, rows: 5}", "type: linear_softening", "penalty"}));

}  // namespace
}  // namespace dda::verification
