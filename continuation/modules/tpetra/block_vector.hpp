#pragma once

#include <Teuchos_RCP.hpp>
#include <Tpetra_Vector.hpp>

#include "continuation/modules/loca/local_vector.hpp"

namespace dda {

using TpetraVector = Tpetra::Vector<double>;
using TpetraMap = Tpetra::Map<>;

/// The unknowns of the blocks as NOX sees them: a thin cover of a Tpetra vector.
///
/// A distributed run is another map; `local()` is always the part that this rank owns. Tested on one rank
/// only.
class BlockVector final : public LocalVector {
 public:
  explicit BlockVector(Teuchos::RCP<const TpetraMap> map) : data_(Teuchos::rcp(new TpetraVector(map))) {}
  BlockVector(const BlockVector& other, NOX::CopyType type);

  BlockVector& operator=(const BlockVector& y);

  /// Rotations and strains carry their own units.
  std::span<double> local() override;
  std::span<const double> local() const override;

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
  NOX::size_type length() const override { return static_cast<NOX::size_type>(data_->getGlobalLength()); }

 private:
  Teuchos::RCP<TpetraVector> data_;
};

}  // namespace dda
