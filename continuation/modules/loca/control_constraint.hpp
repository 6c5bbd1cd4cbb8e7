#pragma once

#include <LOCA_MultiContinuation_ConstraintInterfaceMVDX.H>

#include <memory>

#include "continuation/equation/control_equation.hpp"
#include "continuation/modules/loca/state_vector.hpp"

namespace dda {

/// The control in force, shared by every copy of the constraint.
struct ActiveControl {
  ControlEquation* control = nullptr;
  double residual = 0;  ///< the last N that was computed
};

/// The one adapter that carries every control into LOCA as a constraint with unknown "lambda".
class ControlConstraint final : public LOCA::MultiContinuation::ConstraintInterfaceMVDX {
 public:
  ControlConstraint(System& system, const Teuchos::RCP<const TpetraMap>& map,
                    std::shared_ptr<ActiveControl> active, const State& start);
  ControlConstraint(const ControlConstraint& source, NOX::CopyType type);

  void copy(const ConstraintInterface& source) override;
  Teuchos::RCP<ConstraintInterface> clone(NOX::CopyType type) const override;
  int numConstraints() const override { return 1; }
  void setX(const NOX::Abstract::Vector& x) override;
  void setParam(int id, double value) override;
  void setParams(const std::vector<int>& ids, const NOX::Abstract::MultiVector::DenseMatrix& values) override;
  NOX::Abstract::Group::ReturnType computeConstraints() override;
  NOX::Abstract::Group::ReturnType computeDX() override;
  NOX::Abstract::Group::ReturnType computeDP(const std::vector<int>& ids,
                                             NOX::Abstract::MultiVector::DenseMatrix& dgdp,
                                             bool valid_g) override;
  bool isConstraints() const override { return valid_; }
  bool isDX() const override { return valid_dx_; }
  const NOX::Abstract::MultiVector::DenseMatrix& getConstraints() const override { return value_; }
  const NOX::Abstract::MultiVector* getDX() const override { return dx_.get(); }
  bool isDXZero() const override { return false; }

 private:
  template <class Use>
  auto at_point(Use use) const;
  void invalidate() { valid_ = valid_dx_ = false; }

  System& system_;
  std::shared_ptr<ActiveControl> active_;
  Teuchos::RCP<StateVector> x_;
  double load_factor_ = 0, s_ = 0;
  NOX::Abstract::MultiVector::DenseMatrix value_;
  Teuchos::RCP<NOX::Abstract::MultiVector> dx_;
  double per_load_factor_ = 0;
  bool valid_ = false, valid_dx_ = false;
};

}  // namespace dda
