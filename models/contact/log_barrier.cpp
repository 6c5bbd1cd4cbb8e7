#include <cmath>

#include "models/contact/contact_law.hpp"

namespace dda {
namespace {

/// The logarithmic barrier of incremental potential contact (Li et al. 2020), scaled to the stiffness k where bodies begin
/// to overlap; softer than a spring's closure at small forces:
///
///     ψ(δ) = −½ k δ² ln(1 − δ/(2s))
class LogBarrier final : public ContactLaw {
 public:
  explicit LogBarrier(const NoParameters&) {}
  ContactResponse respond(double overlap, double k, double reach) const override {
    const double left = 1 - overlap / reach, log = std::log(left);
    const double slope = 1 / (reach * left);  // −d ln/dδ
    return {-k / 2 * overlap * overlap * log, k / 2 * (-2 * overlap * log + overlap * overlap * slope),
            k / 2 * (-2 * log + 4 * overlap * slope + overlap * overlap * slope * slope)};
  }
};

}  // namespace

DDA_REGISTER(
    contact_laws(), "log_barrier",
    Schema<NoParameters>("The logarithmic barrier of incremental potential contact; softer at small forces."),
    make_of<LogBarrier>);

}  // namespace dda
