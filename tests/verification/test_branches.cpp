// Where a path may branch, and the branch that nature takes: chains of equal cracks (reference F6), a bar
// that may rotate.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "verification/chain.hpp"
#include "verification/support.hpp"

namespace dda::verification {
namespace {

constexpr double strength = 3, energy = 0.1, critical = 2 * energy / strength;
constexpr double whole = energy * Chain::area;
const std::string law = "{type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}";

Chain chain_of(std::size_t cracks, const std::string& path) {
  return {.laws = std::vector<std::string>(cracks, law), .treatment = "consistent", .path = path};
}

class EqualCracks : public testing::TestWithParam<std::size_t> {};

/// All of them open together: as many negative eigenvalues as cracks, one of which is the limit point's.
TEST_P(EqualCracks, PathStaysSymmetricWhenItFollows) {
  const Trace trace = follow(chain_of(GetParam(), "{stop: {load_below: 0}}").deck());
  const int cracks = static_cast<int>(GetParam());
  EXPECT_EQ(trace.points[0].negative, cracks);
  EXPECT_EQ(trace.points[1].negative, cracks);
  EXPECT_EQ(trace.points[1].negative_under_control, cracks - 1);
  EXPECT_NEAR(trace.last().dissipated, cracks * whole, 1e-8 * whole);
}

/// One opens, the others unload.
TEST_P(EqualCracks, PathLocalisesWhenItSwitches) {
  const Trace trace = follow(chain_of(GetParam(), "{branch: switch, stop: {load_below: 0}}").deck());
  EXPECT_TRUE(trace.points[0].switched);
  EXPECT_NEAR(trace.points[0].load, strength * Chain::area, 1e-6 * strength * Chain::area);
  const double length = static_cast<double>(GetParam() + 1) * Chain::side;
  for (std::size_t i = 1; i + 1 < trace.points.size(); ++i) {
    const Traced& at = trace.points[i];
    EXPECT_FALSE(at.switched);
    EXPECT_EQ(at.negative, 1);
    EXPECT_EQ(at.negative_under_control, 0);
    const double stress = at.load / Chain::area;
    EXPECT_NEAR(at.gauges.at("elongation"),
                stress * length / Chain::young + critical * (1 - stress / strength), 1e-8);
  }
  EXPECT_EQ(trace.ending.kind, Ending::Kind::goal_reached);
  EXPECT_NEAR(trace.last().dissipated, whole, 1e-8 * whole);
}

INSTANTIATE_TEST_SUITE_P(Chains, EqualCracks, testing::Values(2, 3, 5));

/// A saddle point has a negative eigenvalue more for every multiplier; they do not count.
TEST(Branches, MultipliersDoNotCount) {
  Chain chain = chain_of(2, "{stop: {load_below: 0.1}}");
  chain.treatment = "lagrange";
  const Trace trace = follow(chain.deck());
  EXPECT_EQ(trace.points[1].negative, 2);
  EXPECT_EQ(trace.points[1].negative_under_control, 1);
}

/// The other controls know the same branches; what they prescribe decides what is stable under them.
TEST(Branches, ElongationControlIsStableOnTheLocalisedBranchOnly) {
  for (const bool switches : {false, true}) {
    const std::string branch = switches ? "switch" : "follow";
    const Trace trace =
        follow(chain_of(2, "{control: {type: displacement, gauge: elongation}, branch: " + branch +
                               ", stop: {load_below: 0.1}}")
                   .deck());
    EXPECT_EQ(trace.ending.kind, Ending::Kind::goal_reached) << trace.ending.reason;
    for (std::size_t i = 1; i + 1 < trace.points.size(); ++i) {
      EXPECT_EQ(trace.points[i].negative, switches ? 1 : 2);
      EXPECT_EQ(trace.points[i].negative_under_control, switches ? 0 : 1);
    }
  }
}

/// A bar with one interface of two points, pulled along its axis: the symmetric path opens both, the one that
/// nature takes rotates the halves and opens one.
TEST(Branches, PulledBarRotates) {
  const auto deck = [](const std::string& branch) {
    return R"(
scene:
  regions:
    - {material: concrete, vertices: [[0, 0], [500, 0], [500, 100], [0, 100]]}
    - {material: concrete, vertices: [[500, 0], [1000, 0], [1000, 100], [500, 100]]}
  curves: {crack: [[500, 0], [500, 100]]}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0}}
interfaces: {crack: {law: {type: linear_softening, tensile_strength: 3, fracture_energy: 0.1}}}
supports: {pin: {at: [0, 50], fix: xy}, roller: {at: [1000, 50], fix: y}}
stages: [{loads: [{type: point_load, at: [1000, 50], force: [30000, 0]}]}]
path: {stop: {load_below: 0.02}, branch: )" +
           branch + "}\n";
  };
  constexpr double spent = 0.98;  // at 2 % of the peak
  EXPECT_NEAR(follow(deck("follow")).last().dissipated, spent * whole, 1e-8 * whole);
  const Trace rotating = follow(deck("switch"));
  EXPECT_EQ(std::ranges::count(rotating.points, true, &Traced::switched), 1);
  EXPECT_NEAR(rotating.last().dissipated, 0.5 * spent * whole, 1e-5 * whole);
}

}  // namespace
}  // namespace dda::verification
