#include "continuation/modules/loca/group.hpp"

#include <LOCA_GlobalData.H>

namespace dda {

Group::Group(const Teuchos::RCP<LOCA::GlobalData>& global, std::shared_ptr<const ActiveSolve> active,
             const Teuchos::RCP<NOX::Abstract::Vector>& x, double load_factor)
    : LOCA::Abstract::Group(global),
      active_(std::move(active)),
      x_(x),
      f_(x->clone(NOX::ShapeCopy)),
      newton_(x->clone(NOX::ShapeCopy)) {
  parameters_.addParameter("lambda", load_factor);
  parameters_.addParameter("s", 0.0);
}

Group::Group(const Group& source, NOX::CopyType type)
    : LOCA::Abstract::Group(source, type),
      active_(source.active_),
      parameters_(source.parameters_),
      x_(source.x_->clone(type)),
      f_(source.f_->clone(type)),
      newton_(source.newton_->clone(type)) {
  if (type == NOX::DeepCopy) copy(source);
}

NOX::Abstract::Group& Group::operator=(const NOX::Abstract::Group& source) {
  copy(source);
  return *this;
}

Teuchos::RCP<NOX::Abstract::Group> Group::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new Group(*this, type));
}

void Group::copy(const NOX::Abstract::Group& source) {
  const Group& from = dynamic_cast<const Group&>(source);
  if (this == &from) return;
  parameters_ = from.parameters_;
  *x_ = *from.x_;
  valid_jacobian_ = from.valid_jacobian_;
  valid_f_ = from.valid_f_;
  valid_newton_ = from.valid_newton_;
  if (valid_f_) *f_ = *from.f_;
  if (valid_newton_) *newton_ = *from.newton_;
}

void Group::setX(const NOX::Abstract::Vector& x) {
  *x_ = x;
  invalidate();
}

void Group::computeX(const NOX::Abstract::Group& from, const NOX::Abstract::Vector& direction, double step) {
  x_->update(1.0, dynamic_cast<const Group&>(from).getX(), step, direction, 0.0);
  invalidate();
}

NOX::Abstract::Group::ReturnType Group::computeF() {
  if (valid_f_) return Ok;
  *f_ = *x_;  // and as long
  active_->equations->residual(iterate(), local(*f_));
  valid_f_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::computeJacobian() {
  if (valid_jacobian_) return Ok;
  valid_jacobian_ = active_->equations->factorise(iterate());
  return valid_jacobian_ ? Ok : Failed;
}

NOX::Abstract::Group::ReturnType Group::computeNewton(Teuchos::ParameterList& parameters) {
  if (valid_newton_) return Ok;
  if (const ReturnType status = applyJacobianInverse(parameters, *f_, *newton_); status != Ok) return status;
  newton_->scale(-1.0);
  valid_newton_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::applyJacobian(const NOX::Abstract::Vector& in,
                                                      NOX::Abstract::Vector& out) const {
  if (!valid_jacobian_) return BadDependency;
  if (!active_->equations->factorise(iterate())) return Failed;
  out = in;
  active_->equations->multiply(iterate(), local(in), local(out));
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::applyJacobianInverse(Teuchos::ParameterList&,
                                                             const NOX::Abstract::Vector& in,
                                                             NOX::Abstract::Vector& out) const {
  if (!valid_jacobian_) return BadDependency;
  if (!active_->equations->factorise(iterate())) return Failed;
  out = in;
  const std::span<double> column = local(out);
  active_->equations->solve(iterate(), std::span<const std::span<double>>(&column, 1));
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::applyJacobianInverseMultiVector(
    Teuchos::ParameterList&, const NOX::Abstract::MultiVector& in, NOX::Abstract::MultiVector& out) const {
  if (!valid_jacobian_) return BadDependency;
  if (!active_->equations->factorise(iterate())) return Failed;
  std::vector<std::span<double>> columns;
  for (int c = 0; c < in.numVectors(); ++c) {
    out[c] = in[c];
    columns.push_back(local(out[c]));
  }
  active_->equations->solve(iterate(), columns);
  return Ok;
}

void Group::setParams(const LOCA::ParameterVector& p) {
  parameters_ = p;
  invalidate();
}

void Group::setParam(int id, double value) {
  const bool changes_f = id == load_factor_id && value != parameters_.getValue(id);
  parameters_.setValue(id, value);
  if (changes_f) invalidate();
}

void Group::setParam(std::string name, double value) { setParam(parameters_.getIndex(name), value); }

NOX::Abstract::Group::ReturnType Group::computeDfDpMulti(const std::vector<int>& ids,
                                                         NOX::Abstract::MultiVector& dfdp, bool valid_f) {
  if (!valid_f) {
    computeF();
    dfdp[0] = *f_;
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    NOX::Abstract::Vector& column = dfdp[static_cast<int>(i) + 1];
    column = *x_;  // as long
    column.init(0.0);
    if (ids[i] == load_factor_id) active_->equations->load_derivative(iterate(), local(column));
  }
  return Ok;
}

}  // namespace dda
