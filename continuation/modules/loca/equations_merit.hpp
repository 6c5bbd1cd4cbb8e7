#pragma once

#include <NOX_MeritFunction_SumOfSquares.H>
#include <NOX_Utils.H>

#include "continuation/modules/loca/active_solve.hpp"

namespace dda {

/// What a line search of NOX brings down: ½ ‖F‖² of the equations, in one unit (Equations::norm). The control
/// is none of it, being met by a step in full where it is linear.
class EquationsMerit final : public NOX::MeritFunction::SumOfSquares {
 public:
  explicit EquationsMerit(std::shared_ptr<const ActiveSolve> active)
      : SumOfSquares(Teuchos::rcp(new NOX::Utils)), active_(std::move(active)) {}
  double computef(const NOX::Abstract::Group& group) const override;
  /// Of Newton's direction: −‖F‖².
  double computeSlope(const NOX::Abstract::Vector& direction,
                      const NOX::Abstract::Group& group) const override;

 private:
  std::shared_ptr<const ActiveSolve> active_;
};

}  // namespace dda
