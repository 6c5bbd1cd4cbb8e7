#pragma once

#include <LOCA_Abstract_Group.H>
#include <LOCA_Parameter_Vector.H>

#include <memory>

#include "continuation/modules/loca/active_solve.hpp"
#include "continuation/modules/loca/local_vector.hpp"

namespace dda {

/// Equations as a LOCA group: F(x, λ), parameters "lambda" and "s".
///
/// "s" is the abstract path parameter of the user-defined controls, ∂F/∂s = 0. Groups hold values and
/// validity flags; the equations remember what was computed at the last place they were asked.
class Group final : public LOCA::Abstract::Group {
 public:
  static constexpr int load_factor_id = 0, path_id = 1;

  Group(const Teuchos::RCP<LOCA::GlobalData>& global, std::shared_ptr<const ActiveSolve> active,
        const Teuchos::RCP<NOX::Abstract::Vector>& x, double load_factor);
  Group(const Group& source, NOX::CopyType type);

  double load_factor() const { return parameters_.getValue(load_factor_id); }
  Iterate iterate() const { return {std::as_const(*this).entries(), load_factor()}; }

  // NOX
  NOX::Abstract::Group& operator=(const NOX::Abstract::Group& source) override;
  Teuchos::RCP<NOX::Abstract::Group> clone(NOX::CopyType type) const override;
  void copy(const NOX::Abstract::Group& source) override;
  void setX(const NOX::Abstract::Vector& x) override;
  void computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction,
                double step) override;
  ReturnType computeF() override;
  ReturnType computeJacobian() override;
  ReturnType computeNewton(Teuchos::ParameterList& parameters) override;
  ReturnType applyJacobian(const NOX::Abstract::Vector& in, NOX::Abstract::Vector& out) const override;
  ReturnType applyJacobianInverse(Teuchos::ParameterList&, const NOX::Abstract::Vector& in,
                                  NOX::Abstract::Vector& out) const override;
  ReturnType applyJacobianInverseMultiVector(Teuchos::ParameterList&, const NOX::Abstract::MultiVector& in,
                                             NOX::Abstract::MultiVector& out) const override;
  bool isF() const override { return valid_f_; }
  bool isJacobian() const override { return valid_jacobian_; }
  bool isNewton() const override { return valid_newton_; }
  const NOX::Abstract::Vector& getX() const override { return *x_; }
  const NOX::Abstract::Vector& getF() const override { return *f_; }
  double getNormF() const override { return f_->norm(NOX::Abstract::Vector::TwoNorm); }
  const NOX::Abstract::Vector& getGradient() const override { return *f_; }
  const NOX::Abstract::Vector& getNewton() const override { return *newton_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getXPtr() const override { return x_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getFPtr() const override { return f_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getGradientPtr() const override { return f_; }
  Teuchos::RCP<const NOX::Abstract::Vector> getNewtonPtr() const override { return newton_; }

  // LOCA
  void setParams(const LOCA::ParameterVector& p) override;
  void setParam(int id, double value) override;
  void setParam(std::string name, double value) override;
  const LOCA::ParameterVector& getParams() const override { return parameters_; }
  double getParam(int id) const override { return parameters_.getValue(id); }
  double getParam(std::string name) const override { return parameters_.getValue(name); }
  ReturnType computeDfDpMulti(const std::vector<int>& ids, NOX::Abstract::MultiVector& dfdp,
                              bool valid_f) override;
  void printSolution(const double) const override {}
  void printSolution(const NOX::Abstract::Vector&, const double) const override {}

 private:
  std::span<const double> entries() const { return local(std::as_const(*x_)); }
  void invalidate() { valid_f_ = valid_newton_ = valid_jacobian_ = false; }

  std::shared_ptr<const ActiveSolve> active_;
  LOCA::ParameterVector parameters_;
  Teuchos::RCP<NOX::Abstract::Vector> x_, f_, newton_;
  bool valid_f_ = false, valid_newton_ = false, valid_jacobian_ = false;
};

}  // namespace dda
