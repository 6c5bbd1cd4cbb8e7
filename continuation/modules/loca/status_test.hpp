#pragma once

#include <NOX_StatusTest_Generic.H>

#include "continuation/modules/loca/active_solve.hpp"

namespace dda {

/// NOX asks the equations themselves whether an iterate is their solution.
class EquationsTest final : public NOX::StatusTest::Generic {
 public:
  explicit EquationsTest(std::shared_ptr<ActiveSolve> active) : active_(std::move(active)) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream << active_->reason; }

 private:
  std::shared_ptr<ActiveSolve> active_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
};

}  // namespace dda
