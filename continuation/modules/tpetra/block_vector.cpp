#include "continuation/modules/tpetra/block_vector.hpp"

namespace dda {
namespace {

const BlockVector& as_blocks(const NOX::Abstract::Vector& x) { return dynamic_cast<const BlockVector&>(x); }

}  // namespace

BlockVector::BlockVector(const BlockVector& other, NOX::CopyType type)
    : data_(Teuchos::rcp(new TpetraVector(other.data_->getMap(), type == NOX::ShapeCopy))) {
  if (type == NOX::DeepCopy) data_->assign(*other.data_);
}

BlockVector& BlockVector::operator=(const BlockVector& y) {
  data_->assign(*y.data_);
  return *this;
}

std::span<double> BlockVector::local() {
  const auto view = data_->getDataNonConst();
  return {view.getRawPtr(), static_cast<std::size_t>(view.size())};
}

std::span<const double> BlockVector::local() const {
  const auto view = data_->getData();
  return {view.getRawPtr(), static_cast<std::size_t>(view.size())};
}

NOX::Abstract::Vector& BlockVector::init(double value) {
  data_->putScalar(value);
  return *this;
}

NOX::Abstract::Vector& BlockVector::random(bool, int) {
  data_->randomize();
  return *this;
}

NOX::Abstract::Vector& BlockVector::abs(const NOX::Abstract::Vector& y) {
  data_->abs(*as_blocks(y).data_);
  return *this;
}

NOX::Abstract::Vector& BlockVector::operator=(const NOX::Abstract::Vector& y) {
  data_->assign(*as_blocks(y).data_);
  return *this;
}

NOX::Abstract::Vector& BlockVector::reciprocal(const NOX::Abstract::Vector& y) {
  data_->reciprocal(*as_blocks(y).data_);
  return *this;
}

NOX::Abstract::Vector& BlockVector::scale(double factor) {
  data_->scale(factor);
  return *this;
}

NOX::Abstract::Vector& BlockVector::scale(const NOX::Abstract::Vector& factors) {
  data_->elementWiseMultiply(1.0, *as_blocks(factors).data_, *data_, 0.0);
  return *this;
}

NOX::Abstract::Vector& BlockVector::update(double alpha, const NOX::Abstract::Vector& a, double gamma) {
  data_->update(alpha, *as_blocks(a).data_, gamma);
  return *this;
}

NOX::Abstract::Vector& BlockVector::update(double alpha, const NOX::Abstract::Vector& a, double beta,
                                           const NOX::Abstract::Vector& b, double gamma) {
  data_->update(alpha, *as_blocks(a).data_, beta, *as_blocks(b).data_, gamma);
  return *this;
}

Teuchos::RCP<NOX::Abstract::Vector> BlockVector::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new BlockVector(*this, type));
}

double BlockVector::norm(NormType type) const {
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

double BlockVector::norm(const NOX::Abstract::Vector& weights) const {
  BlockVector weighted(*this, NOX::DeepCopy);
  weighted.scale(weights);
  return std::sqrt(innerProduct(weighted));
}

double BlockVector::innerProduct(const NOX::Abstract::Vector& y) const {
  return data_->dot(*as_blocks(y).data_);
}

}  // namespace dda
