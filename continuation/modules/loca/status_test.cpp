#include "continuation/modules/loca/status_test.hpp"

#include <LOCA_MultiContinuation_ExtendedGroup.H>
#include <LOCA_MultiContinuation_ExtendedVector.H>
#include <NOX_Solver_Generic.H>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/modules/loca/group.hpp"

namespace dda {
namespace {

const Group& equilibrium_group(const NOX::Solver::Generic& solver) {
  const auto& extended =
      dynamic_cast<const LOCA::MultiContinuation::ExtendedGroup&>(solver.getSolutionGroup());
  return dynamic_cast<const Group&>(*extended.getBaseLevelUnderlyingGroup());
}

/// Residual of the continuation equation itself, relative to the step; 0 in the natural case.
double continuation_residual(const NOX::Solver::Generic& solver) {
  const auto& extended =
      dynamic_cast<const LOCA::MultiContinuation::ExtendedGroup&>(solver.getSolutionGroup());
  const auto& f = dynamic_cast<const LOCA::MultiContinuation::ExtendedVector&>(extended.getF());
  const double step = std::abs(extended.getStepSize());
  return step > 0 ? std::abs(f.getScalar(0)) / step : std::abs(f.getScalar(0));
}

}  // namespace

NOX::StatusTest::StatusType NewtonTest::checkStatus(const NOX::Solver::Generic& solver,
                                                    NOX::StatusTest::CheckType) {
  if (solver.getNumIterations() == 0) {
    seen_.clear();
    control_.reset();
  }
  return status_ = judge(solver);
}

NOX::StatusTest::StatusType NewtonTest::judge(const NOX::Solver::Generic& solver) {
  const Group& group = equilibrium_group(solver);
  const double norm = group.residual_norm();
  const double control = active_->control ? std::abs(active_->residual) : continuation_residual(solver);
  const double before = residual_;
  residual_ = system_.relative(norm, group.displacement());
  if (!std::isfinite(norm + control)) {
    reason_ = "the residual is not a number";
    return NOX::StatusTest::Failed;
  }
  // A first iteration may close a contact and overshoot. One that grows later, far above the level of all
  // forces, would crack the whole structure, and each of its points takes columns of the update, which stay.
  constexpr double hopeless = 10;
  if (solver.getNumIterations() > 1 && residual_ > hopeless && residual_ > before) {
    reason_ = fmt::format("the iteration diverges (relative residual {:.1e})", residual_);
    return NOX::StatusTest::Failed;
  }
  constexpr double hardly_less = 0.1;
  const bool falls = solver.getNumIterations() > 0 && residual_ <= hardly_less * before;
  if (residual_ > parameters_.tolerance && !falls)
    residual_ = system_.excess_residual(group.residual(), group.displacement(), group.load_factor());
  const std::size_t active_set = system_.active_set(group.laws());
  const bool is_equilibrium = residual_ <= parameters_.tolerance;
  if (is_equilibrium && meets_control(control, active_set)) return NOX::StatusTest::Converged;
  control_ = is_equilibrium ? std::optional(control) : std::nullopt;
  if (solver.getNumIterations() >= parameters_.max_iterations) {
    reason_ = fmt::format("no convergence in {} iterations (relative residual {:.1e})",
                          parameters_.max_iterations, residual_);
    return NOX::StatusTest::Failed;
  }
  if (repeats(active_set)) {
    reason_ = "the iteration cycles between sets of loading points";
    return NOX::StatusTest::Failed;
  }
  // NOX itself may give up from here, and does not say why.
  reason_ = fmt::format("no further iterate was found (relative residual {:.1e})", residual_);
  return NOX::StatusTest::Unconverged;
}

/// Whether N vanishes, or only sizes the step, is small and no longer falls from one equilibrium to the next:
/// between stiff joints that is what the rounding of the openings leaves of it.
bool NewtonTest::meets_control(double control, std::size_t active_set) {
  if (control <= control_tolerance) return true;
  constexpr double small = 1e-4, hardly_less = 0.1;
  const bool only_sizes = !active_->control || active_->control->only_sizes_step();
  const bool is_same_set = !seen_.empty() && seen_.back() == active_set;
  return only_sizes && is_same_set && control <= small && control_ && control > hardly_less * *control_;
}

bool NewtonTest::repeats(std::size_t active_set) {
  const bool new_set = seen_.empty() || seen_.back() != active_set;
  const bool cycle = new_set && std::ranges::find(seen_, active_set) != seen_.end();
  seen_.push_back(active_set);
  return cycle;
}

}  // namespace dda
