#pragma once

#include <LOCA_Abstract_Group.H>
#include <LOCA_Parameter_Vector.H>

#include <memory>
#include <optional>

#include "continuation/modules/loca/state_vector.hpp"
#include "continuation/state/system.hpp"

namespace dda {

/// The equilibrium equations as a LOCA group: F(x) = R(d, λ), parameters "lambda" and "s".
///
/// "s" is the abstract path parameter of the user-defined controls, ∂F/∂s = 0. Groups hold values and
/// validity flags; history, factorisation and laws are the System's. Laws are evaluated once per x and shared
/// by copies.
class Group final : public LOCA::Abstract::Group {
 public:
  static constexpr int load_factor_id = 0, path_id = 1;

  Group(const Teuchos::RCP<LOCA::GlobalData>& global, System& system,
        const Teuchos::RCP<const TpetraMap>& map, const State& start, Metric metric);
  Group(const Group& source, NOX::CopyType type);

  System& system() const { return system_; }
  State state() const;
  std::span<const double> displacement() const { return x_->local(); }
  double load_factor() const { return parameters_.getValue(load_factor_id); }
  const LawValues& laws() const;
  /// R; valid after computeF.
  std::span<const double> residual() const { return std::as_const(*f_).local(); }
  /// ‖R‖ in forces; valid after computeF.
  double residual_norm() const { return system_.residual_norm(f_->local()); }

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
  bool isJacobian() const override { return jacobian_stamp_ != 0; }
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
  double computeScaledDotProduct(const NOX::Abstract::Vector& a,
                                 const NOX::Abstract::Vector& b) const override;
  void scaleVector(NOX::Abstract::Vector& x) const override;
  void printSolution(const double) const override {}
  void printSolution(const NOX::Abstract::Vector&, const double) const override {}

 private:
  void invalidate();
  bool use_jacobian() const;
  void solve_base(std::span<const double> b, std::span<double> y) const;

  System& system_;
  Metric metric_;
  LOCA::ParameterVector parameters_;
  Teuchos::RCP<StateVector> x_, f_, newton_;
  mutable std::shared_ptr<const LawValues> laws_;
  bool valid_f_ = false, valid_newton_ = false;
  std::size_t jacobian_stamp_ = 0;  ///< 0 = none; else the number of this tangent
};

}  // namespace dda
