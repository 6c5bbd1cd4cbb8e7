#pragma once

#include <Teuchos_RCP.hpp>
#include <vector>

#include "continuation/modules/loca/local_vector.hpp"

namespace dda {

/// A short vector whose length follows what is assigned to it, so that unknowns may join between the steps of
/// one stepper. Where two of different length meet, entries that one of them lacks are zero.
class DenseVector final : public LocalVector {
 public:
  explicit DenseVector(std::size_t size) : data_(size, 0.0) {}
  DenseVector(const DenseVector& other, NOX::CopyType type);

  std::span<double> local() override { return data_; }
  std::span<const double> local() const override { return data_; }
  void resize(std::size_t size) { data_.resize(size, 0.0); }

  NOX::Abstract::Vector& init(double value) override;
  NOX::Abstract::Vector& random(bool use_seed, int seed) override;
  NOX::Abstract::Vector& abs(const NOX::Abstract::Vector& y) override;
  NOX::Abstract::Vector& operator=(const NOX::Abstract::Vector& y) override;
  NOX::Abstract::Vector& reciprocal(const NOX::Abstract::Vector& y) override;
  NOX::Abstract::Vector& scale(double factor) override;
  NOX::Abstract::Vector& scale(const NOX::Abstract::Vector& factors) override;
  NOX::Abstract::Vector& update(double alpha, const NOX::Abstract::Vector& a, double gamma) override;
  NOX::Abstract::Vector& update(double alpha, const NOX::Abstract::Vector& a, double beta,
                                const NOX::Abstract::Vector& b, double gamma) override;
  Teuchos::RCP<NOX::Abstract::Vector> clone(NOX::CopyType type) const override;
  double norm(NormType type) const override;
  double norm(const NOX::Abstract::Vector& weights) const override;
  double innerProduct(const NOX::Abstract::Vector& y) const override;
  NOX::size_type length() const override { return static_cast<NOX::size_type>(data_.size()); }

 private:
  void add(double factor, const NOX::Abstract::Vector& y);

  std::vector<double> data_;
};

}  // namespace dda
