#pragma once

#include <NOX_StatusTest_Generic.H>

#include <memory>
#include <optional>
#include <unordered_map>

#include "continuation/modules/loca/control_constraint.hpp"
#include "continuation/solve/stepper.hpp"

namespace dda {

/// Converged when equilibrium and control hold; a residual that does not fall counts without its rounding
/// (System::excess_residual), a control that rounding keeps from falling counts as met; failed on NaN, on too
/// many iterations, and as soon as the set of loading points comes back to one it has left, which plain
/// Newton would repeat for ever.
class NewtonTest final : public NOX::StatusTest::Generic {
 public:
  NewtonTest(System& system, std::shared_ptr<const ActiveControl> active, const NewtonParameters& parameters)
      : system_(system), active_(std::move(active)), parameters_(parameters) {}

  NOX::StatusTest::StatusType checkStatus(const NOX::Solver::Generic& solver,
                                          NOX::StatusTest::CheckType) override;
  NOX::StatusTest::StatusType getStatus() const override { return status_; }
  std::ostream& print(std::ostream& stream, int) const override { return stream << reason_; }

  /// Why the last solve failed.
  const std::string& reason() const { return reason_; }
  /// Smallest residual that was seen, relative to the force level.
  double relative_residual() const { return residual_; }

 private:
  NOX::StatusTest::StatusType judge(const NOX::Solver::Generic& solver);
  bool meets_control(double control, std::size_t active_set);
  bool repeats(std::size_t active_set);

  System& system_;
  std::shared_ptr<const ActiveControl> active_;
  NewtonParameters parameters_;
  NOX::StatusTest::StatusType status_ = NOX::StatusTest::Unevaluated;
  std::string reason_;
  double residual_ = 0;
  std::optional<double> control_;  ///< |N| of the last iteration if that was an equilibrium
  std::vector<std::size_t> seen_;  ///< fingerprints of the active sets of this solve
};

}  // namespace dda
