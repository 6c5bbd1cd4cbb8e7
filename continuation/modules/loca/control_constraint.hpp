#pragma once

#include <LOCA_MultiContinuation_ConstraintInterfaceMVDX.H>

#include "continuation/modules/loca/active_solve.hpp"
#include "continuation/modules/loca/local_vector.hpp"

namespace dda {

/// The one adapter that carries every control into LOCA as a constraint with unknown "lambda",
/// N(x, λ) + ∂N/∂s (s − s_end) = 0.
class ControlConstraint final : public LOCA::MultiContinuation::ConstraintInterfaceMVDX {
 public:
  ControlConstraint(std::shared_ptr<const ActiveSolve> active, const NOX::Abstract::Vector& x,
                    double load_factor);
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
  Iterate iterate() const { return {local(std::as_const(*x_)), load_factor_}; }
  void invalidate() { valid_ = valid_dx_ = false; }

  std::shared_ptr<const ActiveSolve> active_;
  Teuchos::RCP<NOX::Abstract::Vector> x_;
  double load_factor_ = 0, s_ = 0;
  NOX::Abstract::MultiVector::DenseMatrix value_;
  Teuchos::RCP<NOX::Abstract::MultiVector> dx_;
  double per_load_factor_ = 0;
  bool valid_ = false, valid_dx_ = false;
};

}  // namespace dda
