#include "continuation/modules/loca/status_test.hpp"

#include <LOCA_MultiContinuation_ExtendedGroup.H>
#include <NOX_Solver_Generic.H>

#include "continuation/modules/loca/group.hpp"

namespace dda {
namespace {

Iterate iterate_of(const NOX::Solver::Generic& solver) {
  const auto& extended =
      dynamic_cast<const LOCA::MultiContinuation::ExtendedGroup&>(solver.getSolutionGroup());
  return dynamic_cast<const Group&>(*extended.getBaseLevelUnderlyingGroup()).iterate();
}

NOX::StatusTest::StatusType status_of(Verdict::Kind kind) {
  if (kind == Verdict::Kind::converged) return NOX::StatusTest::Converged;
  return kind == Verdict::Kind::failed ? NOX::StatusTest::Failed : NOX::StatusTest::Unconverged;
}

}  // namespace

NOX::StatusTest::StatusType EquationsTest::checkStatus(const NOX::Solver::Generic& solver,
                                                       NOX::StatusTest::CheckType) {
  if (active_->is_start) return status_ = NOX::StatusTest::Converged;
  Verdict verdict = active_->equations->judge(iterate_of(solver), solver.getNumIterations());
  active_->reason = std::move(verdict.reason);
  return status_ = status_of(verdict.kind);
}

}  // namespace dda
