#include "continuation/stability/stiffness_modes.hpp"

#include <algorithm>
#include <memory>

namespace dda {
namespace {

/// A symmetric matrix that no update of the path's own gives.
class WholeMatrix {
 public:
  WholeMatrix(const DirectSolverChoice& choice, const BlockMatrix& k) : solver_(choice.make()) {
    is_regular_ = solver_->factor(k);
  }
  bool is_regular() const { return is_regular_; }
  std::optional<int> num_negative() const {
    const int pivots = solver_->num_negative_pivots();
    return pivots < 0 ? std::nullopt : std::optional(pivots);
  }
  void solve(std::span<const double> b, std::span<double> x) {
    std::ranges::copy(b, x.begin());
    solver_->solve(x, 1);
  }

 private:
  std::unique_ptr<DirectSolver> solver_;
  bool is_regular_ = false;
};

}  // namespace

std::optional<StiffnessModes> stiffness_modes(System& system, const State& state,
                                              const DirectSolverChoice& solver, const ModeRequest& wanted) {
  const auto laws = system.laws_at(state);
  const bool is_whole = wanted.is_physical && !system.is_path_physical(*laws);
  const auto matrix = [&] {
    const bool has_own_stiffness = wanted.is_physical || system.iterates_multipliers();
    return has_own_stiffness ? system.physical_stiffness(*laws) : system.stiffness(state);
  };
  EigenProblem problem{.solve = {}, .shifted = {}, .mass = wanted.mass, .count = wanted.count};
  std::optional<WholeMatrix> whole, shifted;
  problem.shifted = [&](double s) -> InverseOperator {
    BlockMatrix k = matrix();
    wanted.mass.add_to(k, s);
    shifted.emplace(solver, k);
    if (!shifted->is_regular() || shifted->num_negative() != 0) return {};
    return [&](auto b, auto x) { shifted->solve(b, x); };
  };
  if (!is_whole && system.use_path_tangent(*laws) && system.path_linear().has_symmetric_tangent())
    problem.num_negative = system.path_linear().negative_eigenvalues().of_stiffness;
  if (problem.num_negative) {
    problem.solve = [&](auto b, auto x) { system.path_linear().solve(b, x); };
  } else {
    whole.emplace(solver, matrix());
    if (!whole->is_regular()) return {};
    problem.num_negative = whole->num_negative();
    problem.solve = [&](auto b, auto x) { whole->solve(b, x); };
  }
  return StiffnessModes{problem.num_negative, lowest_eigenmodes(problem)};
}

}  // namespace dda
