#include <gtest/gtest.h>

#include "continuation/control/control.hpp"
#include "support/cracked.hpp"

namespace dda {
namespace {

/// Sets the system's laws as a step under the control would.
ControlPoint point_at(const State& state, const LawValues& laws) { return ControlPoint::at(state, laws); }

/// Gradients and per_path against central differences of the residual at the system's cracked state.
void expect_gradients(ControlEquation& control, CrackedSystem& cracked) {
  System& system = cracked.system();
  system.set_frozen(control.freezes_damage());
  const State& at = cracked.state();
  const LawValues laws = system.laws(at);
  const double scale = 0.01;
  control.start_at(point_at(at, laws), scale);
  EXPECT_NEAR(control.residual(point_at(at, laws), 0), 0, 1e-12 / scale) << "a step starts where it stands";
  const auto residual = [&](const State& state, double s) {
    return control.residual(point_at(state, system.laws(state)), s);
  };
  std::vector<double> per_d(at.d.size(), 0.0);
  const double per_load = control.gradient(point_at(at, laws), per_d);
  constexpr double step = 1e-7;
  const double size = vec(per_d).norm() + std::abs(per_load);
  EXPECT_GT(size, 0);
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> along = cracked.direction();
    const double difference =
        (residual(cracked.moved(along, step), 0.3) - residual(cracked.moved(along, -step), 0.3)) / (2 * step);
    EXPECT_NEAR(vec(per_d).dot(vec(along)), difference, 1e-5 * size);
  }
  State above = at, below = at;
  above.load_factor += step;
  below.load_factor -= step;
  EXPECT_NEAR(per_load, (residual(above, 0.3) - residual(below, 0.3)) / (2 * step), 1e-5 * size);
  EXPECT_NEAR(control.per_path(), (residual(at, 0.6) - residual(at, 0.4)) / 0.2,
              1e-9 * std::abs(control.per_path()));
  system.set_frozen(false);
}

class ControlContract : public testing::TestWithParam<std::tuple<std::string, int>> {
 protected:
  static CrackedSystem next() {
    const auto& [treatment, seed] = GetParam();
    return CrackedSystem(cracked_square(treatment), static_cast<std::uint64_t>(seed));
  }
};

/// Dissipation is measured from the history, so its start is the committed state: only growth is compared.
TEST_P(ControlContract, DissipationGradientsAreDifferences) {
  CrackedSystem cracked = next();
  const auto control = make_dissipation_equation(cracked.system());
  const State& at = cracked.state();
  const LawValues laws = cracked.system().laws(at);
  control->start_at(point_at(at, laws), 0.01);
  const auto residual = [&](const State& state) {
    return control->residual(point_at(state, cracked.system().laws(state)), 0);
  };
  const double grown = cracked.system().dissipated(cracked.system().next_history(at)) -
                       cracked.system().dissipated(cracked.system().history());
  EXPECT_GT(grown, 0);
  EXPECT_NEAR(0.01 * residual(at), grown, 1e-12 * grown);
  EXPECT_EQ(control->per_path(), -100);
  std::vector<double> per_d(at.d.size(), 0.0);
  const double per_load = control->gradient(point_at(at, laws), per_d);
  constexpr double step = 1e-7;
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> along = cracked.direction();
    const double difference =
        (residual(cracked.moved(along, step)) - residual(cracked.moved(along, -step))) / (2 * step);
    EXPECT_NEAR(vec(per_d).dot(vec(along)), difference, 1e-6 * vec(per_d).norm());
  }
  State above = at, below = at;
  above.load_factor += step;
  below.load_factor -= step;
  EXPECT_NEAR(per_load, (residual(above) - residual(below)) / (2 * step), 1e-6 * vec(per_d).norm());
}

TEST_P(ControlContract, GaugeGradientsAreDifferences) {
  CrackedSystem cracked = next();
  for (const auto& [name, reaction] : cracked.system().loading().reactions)
    expect_gradients(*make_gauge_equation(reaction), cracked);
  expect_gradients(*make_gauge_equation({.rows = {}, .per_load_factor = 1}), cracked);
}

TEST_P(ControlContract, EventGradientsAreDifferences) {
  CrackedSystem cracked = next();
  expect_gradients(*make_event_equation(cracked.system()), cracked);
}

INSTANTIATE_TEST_SUITE_P(States, ControlContract,
                         testing::Combine(testing::Values("consistent", "lagrange", "augmented_lagrangian"),
                                          testing::Range(1, 4)));

class MoveContract : public testing::TestWithParam<std::string> {};

TEST_P(MoveContract, FirstMoveIsAControlOfTheElasticStructure) {
  CrackedSystem cracked(
      square_deck("gauges:\n"
                  "  u: {type: displacement, at: [1, 0.5], direction: [1, 0]}\n"
                  "  w: {type: relative_displacement, from: [0.3, 0.5], to: [0.9, 0.6]}\n"));
  System& system = cracked.system();
  system.set_history(std::vector<History>(system.history().size()));
  Stepper stepper(system, {});
  Walker walker(stepper);
  const GaugeBook book{system.loading().gauges, "u", "w"};
  const SchemaBase& schema = *controls().find(GetParam())->schema;
  Random random(5);
  const auto control = controls().choose(GetParam(), sample(schema, random)).make(book);
  const Move move = control->next(walker);
  ASSERT_TRUE(move.equation);
  EXPECT_TRUE(std::isfinite(move.rate));
  const LawValues laws = system.laws(walker.state().d, 0);
  move.equation->start_at({walker.state().d, 0, laws}, 1);
  EXPECT_NEAR(move.equation->residual({walker.state().d, 0, laws}, 0), 0, 1e-12);
  EXPECT_NE(move.equation->per_path(), 0);
}

INSTANTIATE_TEST_SUITE_P(Registry, MoveContract, testing::ValuesIn(names_of(controls())),
                         [](const auto& chosen) { return chosen.param; });

}  // namespace
}  // namespace dda
