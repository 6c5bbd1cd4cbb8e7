#include "continuation/modules/loca/state_vector.hpp"

namespace dda {

StateVector::StateVector(const StateVector& other, NOX::CopyType type)
    : data_(Teuchos::rcp(new TpetraVector(other.data_->getMap(), type == NOX::ShapeCopy))) {
  if (type == NOX::DeepCopy) data_->assign(*other.data_);
}

StateVector& StateVector::operator=(const StateVector& y) {
  data_->assign(*y.data_);
  return *this;
}

std::span<double> StateVector::local() {
  const auto view = data_->getDataNonConst();
  return {view.getRawPtr(), static_cast<std::size_t>(view.size())};
}

std::span<const double> StateVector::local() const {
  const auto view = data_->getData();
  return {view.getRawPtr(), static_cast<std::size_t>(view.size())};
}

NOX::Abstract::Vector& StateVector::init(double value) {
  data_->putScalar(value);
  return *this;
}

NOX::Abstract::Vector& StateVector::random(bool, int) {
  data_->randomize();
  return *this;
}

NOX::Abstract::Vector& StateVector::abs(const NOX::Abstract::Vector& y) {
  data_->abs(*as_state(y).data_);
  return *this;
}

NOX::Abstract::Vector& StateVector::operator=(const NOX::Abstract::Vector& y) {
  data_->assign(*as_state(y).data_);
  return *this;
}

NOX::Abstract::Vector& StateVector::reciprocal(const NOX::Abstract::Vector& y) {
  data_->reciprocal(*as_state(y).data_);
  return *this;
}

NOX::Abstract::Vector& StateVector::scale(double factor) {
  data_->scale(factor);
  return *this;
}

NOX::Abstract::Vector& StateVector::scale(const NOX::Abstract::Vector& factors) {
  data_->elementWiseMultiply(1.0, *as_state(factors).data_, *data_, 0.0);
  return *this;
}

NOX::Abstract::Vector& StateVector::update(double alpha, const NOX::Abstract::Vector& a, double gamma) {
  data_->update(alpha, *as_state(a).data_, gamma);
  return *this;
}

NOX::Abstract::Vector& StateVector::update(double alpha, const NOX::Abstract::Vector& a, double beta,
                                           const NOX::Abstract::Vector& b, double gamma) {
  data_->update(alpha, *as_state(a).data_, beta, *as_state(b).data_, gamma);
  return *this;
}

Teuchos::RCP<NOX::Abstract::Vector> StateVector::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new StateVector(*this, type));
}

double StateVector::norm(NormType type) const {
  switch (type) {
    case MaxNorm:
      return data_->normInf();
    case OneNorm:
      return data_->norm1();
    case TwoNorm:
      break;
  }
  return data_->norm2();
}

double StateVector::norm(const NOX::Abstract::Vector& weights) const {
  StateVector weighted(*this, NOX::DeepCopy);
  weighted.scale(weights);
  return std::sqrt(innerProduct(weighted));
}

double StateVector::innerProduct(const NOX::Abstract::Vector& y) const {
  return data_->dot(*as_state(y).data_);
}

const StateVector& as_state(const NOX::Abstract::Vector& x) { return dynamic_cast<const StateVector&>(x); }
StateVector& as_state(NOX::Abstract::Vector& x) { return dynamic_cast<StateVector&>(x); }

}  // namespace dda
