#pragma once

#include <NOX_Abstract_Vector.H>

#include <Teuchos_RCP.hpp>
#include <Tpetra_Vector.hpp>
#include <span>

namespace dda {

using TpetraVector = Tpetra::Vector<double>;
using TpetraMap = Tpetra::Map<>;

/// The unknowns of the blocks as NOX sees them: a thin cover of a Tpetra vector.
///
/// A distributed run is another map; `local()` is always the part that this rank owns. Tested on one rank
/// only.
class StateVector final : public NOX::Abstract::Vector {
 public:
  explicit StateVector(Teuchos::RCP<const TpetraMap> map) : data_(Teuchos::rcp(new TpetraVector(map))) {}
  StateVector(const StateVector& other, NOX::CopyType type);

  StateVector& operator=(const StateVector& y);

  /// Owned entries; rotations and strains carry their own units.
  std::span<double> local();
  std::span<const double> local() const;
  /// LOCA forms W v by asking twice for W^½ v; a metric that is no diagonal is applied at the second request,
  /// and this remembers the first. True at every second call.
  bool take_second_half() { return (half_scaled_ = !half_scaled_, !half_scaled_); }

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
  bool half_scaled_ = false;
};

/// The StateVector behind a NOX vector.
const StateVector& as_state(const NOX::Abstract::Vector& x);
StateVector& as_state(NOX::Abstract::Vector& x);

}  // namespace dda
