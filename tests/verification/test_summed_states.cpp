// A step that knows its state as a sum of kept solutions is the same step: openings, gauges, equilibrium, energies
// and work of the whole structure are those that the sum tells.
#include <gtest/gtest.h>

#include <numeric>

#include "studies/dda/case/simulation.hpp"

namespace dda::verification {
namespace {

/// Three-point bending of a beam with its own weight, which cracks along the middle only.
std::string beam(const std::string& law) {
  return R"(
units: {length: mm, force: N}
scene:
  regions:
    - {material: concrete, vertices: [[0, 0], [1200, 0], [1200, 60], [0, 60]]}
  curves: {ligament: [[600, 0], [600, 60]]}
  subdivision: {type: quads, size: 6}
thickness: 100
materials: {concrete: {type: linear_elastic, young_modulus: 30000, poisson_ratio: 0.2}}
interfaces:
  ligament: {law: )" +
         law + R"(}
supports:
  left: {at: [0, 0], fix: xy}
  right: {at: [1200, 0], fix: y}
stages:
  - {name: weight, loads: [{type: body_force, force: [0, -2.4e-5]}]}
  - name: bending
    loads:
      - {type: point_load, at: [600, 60], inside: [599, 59], force: [0, -0.5]}
      - {type: point_load, at: [600, 60], inside: [601, 59], force: [0, -0.5]}
gauges:
  deflection: {type: displacement, at: [600, 60], inside: [599, 59], direction: [0, -1]}
path: {stop: {load_below: 0.2}}
)";
}

class SummedStates : public testing::TestWithParam<std::string> {
 protected:
  SummedStates() {
    simulation_.prepare();
    EXPECT_EQ(simulation_.apply_dead_loads(), "");
    simulation_.begin_path();
  }

  void expect_the_whole_agrees() {
    const Candidate& here = simulation_.walker().here();
    System& system = simulation_.system();
    EXPECT_LT(system.excess_residual(here.state), 1e-9);
    const std::vector<double> d = here.state.d.all();
    const State whole{d, here.state.load_factor};
    for (std::size_t p = 0; p < system.equilibrium().num_active(); ++p)
      EXPECT_NEAR((system.jump(p, here.state.d) - system.jump(p, whole.d)).norm(), 0, 1e-11);
    for (const NamedGauge& gauge : system.loading().gauges)
      EXPECT_NEAR(here.state.value(gauge.functional), whole.value(gauge.functional), 1e-11);
    for (const auto& [name, reaction] : system.loading().reactions)
      EXPECT_NEAR(here.state.value(reaction), whole.value(reaction), 1e-9 * system.sum_of_forces(whole));
    EXPECT_NEAR(system.stored(whole, system.laws(whole)), here.stored, 1e-9 * here.stored);
    const std::vector<double>& weight = system.loading().dead_work;
    const double work = std::inner_product(weight.begin(), weight.end(), d.begin(), 0.0);
    EXPECT_NEAR(system.dead_work(here.state), work, 1e-10 * std::abs(work));
    EXPECT_NEAR(here.work, here.stored + here.dissipated, 1e-3 * here.work);
  }

  DeckFile file_ = deck_from_text(beam(GetParam()), "beam.yaml", {});
  Timings timings_;
  Simulation simulation_{file_.deck, timings_};
};

TEST_P(SummedStates, TellWhatTheWholeDoes) {
  int steps = 0, summed = 0;
  for ([[maybe_unused]] const Point& point : simulation_.path()) {
    ++steps;
    summed += !simulation_.walker().state().d.are_all_known();
    expect_the_whole_agrees();
  }
  EXPECT_EQ(simulation_.path().ending().kind, Ending::Kind::goal_reached);
  EXPECT_GT(2 * summed, steps);
}

INSTANTIATE_TEST_SUITE_P(
    Laws, SummedStates,
    testing::Values("{type: linear_softening, tensile_strength: 3, fracture_energy: 0.05}",
                    "{type: exponential_softening, tensile_strength: 3, fracture_energy: 0.01, "
                    "shear_fracture_energy: 0.1, cohesion: 6, friction_angle: 35}"));

}  // namespace
}  // namespace dda::verification
