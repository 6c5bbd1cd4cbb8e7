#pragma once

#include <NOX_Direction_Generic.H>
#include <NOX_Direction_UserDefinedFactory.H>

#include <Teuchos_ParameterList.hpp>

#include "continuation/modules/loca/active_solve.hpp"

namespace dda {

/// To where a finite walk ends (WalkedEquations::walk_from), as a direction of NOX: in full it is the solution.
class WalkDirection final : public NOX::Direction::Generic {
 public:
  explicit WalkDirection(std::shared_ptr<const ActiveSolve> active) : active_(std::move(active)) {}
  bool reset(const Teuchos::RCP<NOX::GlobalData>&, Teuchos::ParameterList&) override { return true; }
  bool compute(NOX::Abstract::Vector& direction, NOX::Abstract::Group& group,
               const NOX::Solver::Generic& solver) override;

 private:
  std::shared_ptr<const ActiveSolve> active_;
};

/// Makes them for NOX.
class WalkDirectionFactory final : public NOX::Direction::UserDefinedFactory {
 public:
  explicit WalkDirectionFactory(std::shared_ptr<const ActiveSolve> active) : active_(std::move(active)) {}
  Teuchos::RCP<NOX::Direction::Generic> buildDirection(const Teuchos::RCP<NOX::GlobalData>&,
                                                       Teuchos::ParameterList&) const override {
    return Teuchos::rcp(new WalkDirection(active_));
  }

 private:
  std::shared_ptr<const ActiveSolve> active_;
};

}  // namespace dda
