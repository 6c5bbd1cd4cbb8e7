#include "continuation/modules/loca/control_constraint.hpp"

#include <algorithm>

#include "continuation/modules/loca/group.hpp"

namespace dda {

using Status = NOX::Abstract::Group::ReturnType;

ControlConstraint::ControlConstraint(System& system, const Teuchos::RCP<const TpetraMap>& map,
                                     std::shared_ptr<ActiveControl> active, const State& start)
    : system_(system),
      active_(std::move(active)),
      x_(Teuchos::rcp(new StateVector(map))),
      load_factor_(start.load_factor),
      value_(1, 1),
      dx_(x_->createMultiVector(1, NOX::ShapeCopy)) {
  std::ranges::copy(start.d, x_->local().begin());
}

ControlConstraint::ControlConstraint(const ControlConstraint& source, NOX::CopyType type)
    : system_(source.system_),
      active_(source.active_),
      x_(Teuchos::rcp(new StateVector(*source.x_, type))),
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

template <class Use>
auto ControlConstraint::at_point(Use use) const {
  const auto laws = system_.laws_at(x_->local(), load_factor_);
  return use(ControlPoint{std::as_const(*x_).local(), load_factor_, *laws});
}

Status ControlConstraint::computeConstraints() {
  if (valid_) return NOX::Abstract::Group::Ok;
  value_(0, 0) = at_point([&](const ControlPoint& at) { return active_->control->residual(at, s_); });
  active_->residual = value_(0, 0);
  valid_ = true;
  return NOX::Abstract::Group::Ok;
}

Status ControlConstraint::computeDX() {
  if (valid_dx_) return NOX::Abstract::Group::Ok;
  dx_->init(0.0);
  const auto per_d = as_state((*dx_)[0]).local();
  per_load_factor_ = at_point([&](const ControlPoint& at) { return active_->control->gradient(at, per_d); });
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
        ids[i] == Group::load_factor_id ? per_load_factor_ : active_->control->per_path();
  return NOX::Abstract::Group::Ok;
}

}  // namespace dda
