#include <gmock/gmock.h>

#include "continuation/detour/increment/load_increment.hpp"
#include "support/cracked.hpp"

namespace dda {
namespace {

/// Every solver of load increments on the square whose joints are damaged and unload, under all loads.
class LoadSolverContract : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  LoadSolverContract() : cracked_(cracked_square(std::get<1>(GetParam()))) {
    std::vector<History> history = system().history();
    for (std::size_t p = 0; p < history.size(); ++p) {
      const InterfacePoint& point = system().equilibrium().point(p);
      history[p] = point.law->grown(history[p], point.stiffness, 2);
      history[p].loading = history[p].sliding = false;
    }
    system().set_history(history);
    start_.d = std::vector<double>(system().equilibrium().num_unknowns(), 0.0);
    start_.multipliers = system().multipliers();
  }

  System& system() { return cracked_.system(); }
  std::unique_ptr<LoadSolver> solver() const { return load_solvers().choose(std::get<0>(GetParam())).make(); }
  Found find(LoadSolver& solver, double load_factor) {
    system().set_multipliers(start_.multipliers);
    return solver.solve(stepper_, start_, load_factor);
  }

  CrackedSystem cracked_;
  State start_;
  Stepper stepper_{system(), {}};
};

TEST_P(LoadSolverContract, FindsTheEquilibriumThatNewtonFinds) {
  const auto made = solver(), newton = load_solvers().choose("newton").make();
  EXPECT_EQ(made->refusal(system().equilibrium()), "");
  for (const double load_factor : {0.3, 0.2}) {
    const Found expected = find(*newton, load_factor), found = find(*made, load_factor);
    ASSERT_TRUE(expected.state && found.state) << found.why << expected.why;
    EXPECT_EQ(found.why, "");
    EXPECT_EQ(found.state->load_factor, load_factor);
    EXPECT_GT(found.newton_iterations + found.relaxation_iterations, 0);
    EXPECT_LE(system().excess_residual(*found.state), stepper_.parameters().newton.tolerance);
    const double size = vec(expected.state->d).norm();
    EXPECT_NEAR((vec(found.state->d) - vec(expected.state->d)).norm() / size, 0, 1e-6);
  }
}

TEST_P(LoadSolverContract, HistoryAndMultipliersStayWhenAnIncrementIsTried) {
  const auto made = solver();
  const std::vector<History> before = system().history();
  const Increment found = load_increment(stepper_, start_, {0.3, *made});
  ASSERT_TRUE(found.settled) << found.why;
  EXPECT_NEAR(found.settled->state.load_factor, 0.3, 1e-15);
  for (std::size_t p = 0; p < before.size(); ++p)
    EXPECT_EQ(system().history()[p].memory.numbers(), before[p].memory.numbers());
  EXPECT_EQ(system().multipliers(), start_.multipliers);
}

INSTANTIATE_TEST_SUITE_P(Registry, LoadSolverContract,
                         testing::Combine(testing::ValuesIn([] {
                                            std::vector<std::string> names;
                                            for (const FamilyMember* member : load_solvers().entries())
                                              names.push_back(member->name);
                                            return names;
                                          }()),
                                          testing::Values("consistent", "penalty", "augmented_lagrangian")));

}  // namespace
}  // namespace dda
