#include "continuation/modules/loca/control_constraint.hpp"

#include "continuation/modules/loca/group.hpp"

namespace dda {

using Status = NOX::Abstract::Group::ReturnType;

ControlConstraint::ControlConstraint(std::shared_ptr<const ActiveSolve> active,
                                     const NOX::Abstract::Vector& x, double load_factor)
    : active_(std::move(active)),
      x_(x.clone(NOX::DeepCopy)),
      load_factor_(load_factor),
      value_(1, 1),
      dx_(x.createMultiVector(1, NOX::ShapeCopy)) {}

ControlConstraint::ControlConstraint(const ControlConstraint& source, NOX::CopyType type)
    : active_(source.active_),
      x_(source.x_->clone(type)),
      value_(1, 1),
      dx_(source.dx_->clone(NOX::ShapeCopy)) {
  if (type == NOX::DeepCopy) copy(source);
}

void ControlConstraint::copy(const ConstraintInterface& source) {
  const auto& from = dynamic_cast<const ControlConstraint&>(source);
  if (this == &from) return;
  *x_ = *from.x_;
  load_factor_ = from.load_factor_;
  s_ = from.s_;
  value_.assign(from.value_);
  per_load_factor_ = from.per_load_factor_;
  valid_ = from.valid_;
  valid_dx_ = from.valid_dx_;
  if (valid_dx_) *dx_ = *from.dx_;
}

Teuchos::RCP<LOCA::MultiContinuation::ConstraintInterface> ControlConstraint::clone(
    NOX::CopyType type) const {
  return Teuchos::rcp(new ControlConstraint(*this, type));
}

void ControlConstraint::setX(const NOX::Abstract::Vector& x) {
  *x_ = x;
  invalidate();
}

void ControlConstraint::setParam(int id, double value) {
  (id == Group::load_factor_id ? load_factor_ : s_) = value;
  invalidate();
}

void ControlConstraint::setParams(const std::vector<int>& ids,
                                  const NOX::Abstract::MultiVector::DenseMatrix& values) {
  for (std::size_t i = 0; i < ids.size(); ++i) setParam(ids[i], values(static_cast<int>(i), 0));
}

Status ControlConstraint::computeConstraints() {
  if (valid_) return NOX::Abstract::Group::Ok;
  Equations& equations = *active_->equations;
  value_(0, 0) = equations.control(iterate()) + equations.per_path() * (s_ - active_->step);
  valid_ = true;
  return NOX::Abstract::Group::Ok;
}

Status ControlConstraint::computeDX() {
  if (valid_dx_) return NOX::Abstract::Group::Ok;
  NOX::Abstract::Vector& gradient = (*dx_)[0];
  gradient = *x_;  // as long
  gradient.init(0.0);
  per_load_factor_ = active_->equations->control_gradient(iterate(), local(gradient));
  valid_dx_ = true;
  return NOX::Abstract::Group::Ok;
}

Status ControlConstraint::computeDP(const std::vector<int>& ids,
                                    NOX::Abstract::MultiVector::DenseMatrix& dgdp, bool valid_g) {
  if (!valid_g) {
    computeConstraints();
    dgdp(0, 0) = value_(0, 0);
  }
  computeDX();
  for (std::size_t i = 0; i < ids.size(); ++i)
    dgdp(0, static_cast<int>(i) + 1) =
        ids[i] == Group::load_factor_id ? per_load_factor_ : active_->equations->per_path();
  return NOX::Abstract::Group::Ok;
}

}  // namespace dda
