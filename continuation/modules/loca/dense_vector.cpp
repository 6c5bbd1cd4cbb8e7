#include "continuation/modules/loca/dense_vector.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace dda {

DenseVector::DenseVector(const DenseVector& other, NOX::CopyType type) {
  if (type == NOX::DeepCopy)
    data_ = other.data_;
  else
    data_.assign(other.data_.size(), 0.0);
}

NOX::Abstract::Vector& DenseVector::init(double value) {
  std::ranges::fill(data_, value);
  return *this;
}

NOX::Abstract::Vector& DenseVector::random(bool use_seed, int seed) {
  static std::mt19937 generator;
  if (use_seed) generator.seed(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> values(-1, 1);
  for (double& entry : data_) entry = values(generator);
  return *this;
}

NOX::Abstract::Vector& DenseVector::abs(const NOX::Abstract::Vector& y) {
  *this = y;
  for (double& entry : data_) entry = std::abs(entry);
  return *this;
}

NOX::Abstract::Vector& DenseVector::operator=(const NOX::Abstract::Vector& y) {
  if (this == &y) return *this;
  const auto from = dda::local(y);
  data_.assign(from.begin(), from.end());
  return *this;
}

NOX::Abstract::Vector& DenseVector::reciprocal(const NOX::Abstract::Vector& y) {
  *this = y;
  for (double& entry : data_) entry = 1 / entry;
  return *this;
}

NOX::Abstract::Vector& DenseVector::scale(double factor) {
  for (double& entry : data_) entry *= factor;
  return *this;
}

NOX::Abstract::Vector& DenseVector::scale(const NOX::Abstract::Vector& factors) {
  const auto by = dda::local(factors);
  for (std::size_t i = 0; i < data_.size(); ++i) data_[i] *= i < by.size() ? by[i] : 0;
  return *this;
}

/// x ← γ x + α a, as long as the longer of them; as `a` where x does not count.
NOX::Abstract::Vector& DenseVector::update(double alpha, const NOX::Abstract::Vector& a, double gamma) {
  if (gamma == 0) return (*this = a).scale(alpha);
  scale(gamma);
  add(alpha, a);
  return *this;
}

NOX::Abstract::Vector& DenseVector::update(double alpha, const NOX::Abstract::Vector& a, double beta,
                                           const NOX::Abstract::Vector& b, double gamma) {
  update(alpha, a, gamma);
  add(beta, b);
  return *this;
}

void DenseVector::add(double factor, const NOX::Abstract::Vector& y) {
  const auto from = dda::local(y);
  if (from.size() > data_.size()) data_.resize(from.size(), 0.0);
  for (std::size_t i = 0; i < from.size(); ++i) data_[i] += factor * from[i];
}

Teuchos::RCP<NOX::Abstract::Vector> DenseVector::clone(NOX::CopyType type) const {
  return Teuchos::rcp(new DenseVector(*this, type));
}

double DenseVector::norm(NormType type) const {
  double out = 0;
  for (const double entry : data_) switch (type) {
      case MaxNorm:
        out = std::max(out, std::abs(entry));
        break;
      case OneNorm:
        out += std::abs(entry);
        break;
      case TwoNorm:
        out += entry * entry;
    }
  return type == TwoNorm ? std::sqrt(out) : out;
}

double DenseVector::norm(const NOX::Abstract::Vector& weights) const {
  const auto by = dda::local(weights);
  double out = 0;
  for (std::size_t i = 0; i < std::min(data_.size(), by.size()); ++i) out += by[i] * data_[i] * data_[i];
  return std::sqrt(out);
}

double DenseVector::innerProduct(const NOX::Abstract::Vector& y) const {
  const auto other = dda::local(y);
  double out = 0;
  for (std::size_t i = 0; i < std::min(data_.size(), other.size()); ++i) out += data_[i] * other[i];
  return out;
}

}  // namespace dda
