#include "continuation/modules/loca/group.hpp"

#include <LOCA_GlobalData.H>

#include <algorithm>
#include <numeric>

namespace dda {

Group::Group(const Teuchos::RCP<LOCA::GlobalData>& global, System& system,
             const Teuchos::RCP<const TpetraMap>& map, const State& start, Metric metric)
    : LOCA::Abstract::Group(global),
      system_(system),
      metric_(metric),
      x_(Teuchos::rcp(new StateVector(map))),
      f_(Teuchos::rcp(new StateVector(map))),
      newton_(Teuchos::rcp(new StateVector(map))) {
  parameters_.addParameter("lambda", start.load_factor);
  parameters_.addParameter("s", 0.0);
  std::ranges::copy(start.d, x_->local().begin());
}

Group::Group(const Group& source, NOX::CopyType type)
    : LOCA::Abstract::Group(source, type),
      system_(source.system_),
      metric_(source.metric_),
      parameters_(source.parameters_),
      x_(Teuchos::rcp(new StateVector(*source.x_, type))),
      f_(Teuchos::rcp(new StateVector(*source.f_, type))),
      newton_(Teuchos::rcp(new StateVector(*source.newton_, type))) {
  if (type == NOX::DeepCopy) copy(source);
}

State Group::state() const {
  const auto local = x_->local();
  return {{local.begin(), local.end()}, load_factor()};
}

const LawValues& Group::laws() const {
  if (!laws_) laws_ = system_.laws_at(x_->local(), load_factor());
  return *laws_;
}

void Group::invalidate() {
  laws_.reset();
  valid_f_ = valid_newton_ = false;
  jacobian_stamp_ = 0;
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
  laws_ = from.laws_;
  jacobian_stamp_ = from.jacobian_stamp_;
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
  system_.residual(x_->local(), load_factor(), laws(), f_->local());
  valid_f_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::computeJacobian() {
  if (jacobian_stamp_ != 0) return Ok;
  jacobian_stamp_ = system_.new_stamp();
  return use_jacobian() ? Ok : Failed;
}

/// Copies of this group may have put their tangent into the shared linear system: put ours back.
bool Group::use_jacobian() const { return system_.use_tangent(jacobian_stamp_, laws().tangent); }

NOX::Abstract::Group::ReturnType Group::computeNewton(Teuchos::ParameterList& parameters) {
  if (valid_newton_) return Ok;
  if (const ReturnType status = applyJacobianInverse(parameters, *f_, *newton_); status != Ok) return status;
  newton_->scale(-1.0);
  valid_newton_ = true;
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::applyJacobian(const NOX::Abstract::Vector& in,
                                                      NOX::Abstract::Vector& out) const {
  if (jacobian_stamp_ == 0) return BadDependency;
  if (!use_jacobian()) return Failed;
  system_.linear().multiply(as_state(in).local(), as_state(out).local());
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::applyJacobianInverse(Teuchos::ParameterList&,
                                                             const NOX::Abstract::Vector& in,
                                                             NOX::Abstract::Vector& out) const {
  if (jacobian_stamp_ == 0) return BadDependency;
  if (!use_jacobian()) return Failed;
  const std::span<double> x = as_state(out).local();
  solve_base(as_state(in).local(), x);
  system_.linear().correct(std::span<const std::span<double>>(&x, 1));
  return Ok;
}

NOX::Abstract::Group::ReturnType Group::applyJacobianInverseMultiVector(
    Teuchos::ParameterList&, const NOX::Abstract::MultiVector& in, NOX::Abstract::MultiVector& out) const {
  if (jacobian_stamp_ == 0) return BadDependency;
  if (!use_jacobian()) return Failed;
  std::vector<std::span<double>> columns;
  for (int c = 0; c < in.numVectors(); ++c) {
    columns.push_back(as_state(out[c]).local());
    solve_base(as_state(in[c]).local(), columns.back());
  }
  system_.linear().correct(columns);
  return Ok;
}

/// The residual far from convergence lives on the cracked points alone and needs no solve; close to it a true
/// solve takes off the round-off of what was kept.
void Group::solve_base(std::span<const double> b, std::span<double> y) const {
  constexpr double close = 1e-6;
  const bool own_residual = valid_f_ && std::ranges::equal(b, std::as_const(*f_).local());
  if (own_residual && residual_norm() > close * system_.force_level(displacement()) &&
      system_.solve_base_residual(displacement(), load_factor(), laws(), y))
    return;
  system_.linear().solve_base(b, y);
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
    StateVector& column = as_state(dfdp[static_cast<int>(i) + 1]);
    if (ids[i] == load_factor_id)
      system_.load_derivative(laws(), column.local());
    else
      column.init(0.0);
  }
  return Ok;
}

double Group::computeScaledDotProduct(const NOX::Abstract::Vector& a, const NOX::Abstract::Vector& b) const {
  std::vector<double> weighted(as_state(b).local().begin(), as_state(b).local().end());
  system_.apply_metric(metric_, weighted);
  const auto left = as_state(a).local();
  return std::inner_product(left.begin(), left.end(), weighted.begin(), 0.0);
}

void Group::scaleVector(NOX::Abstract::Vector& x) const {
  StateVector& state = as_state(x);
  if (state.take_second_half()) system_.apply_metric(metric_, state.local());
}

}  // namespace dda
