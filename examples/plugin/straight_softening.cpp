#include <algorithm>
#include <limits>

#include "models/interface/softening/softening_parameters.hpp"

namespace dda {
namespace {

/// g(ω) = 1 − ω/2 down to ω = 2: the curve of `linear_softening`, written out, so that both can be compared.
///
/// Another curve needs its own seven functions and nothing else: mixed mode, friction, unloading, contact, energy and the
/// tangent are DamageLaw's.
class StraightShape final : public SofteningShape {
 public:
  double value(double omega) const override { return std::max(1 - omega / 2, 0.0); }
  double slope(double omega) const override { return omega < 2 ? -0.5 : 0; }
  double steepest() const override { return 0.5; }
  double end() const override { return 2; }
  double next_corner(double omega) const override {
    return omega < 2 ? 2 : std::numeric_limits<double>::infinity();
  }
  /// The area below the curve, less what unloading to the origin gives back.
  double spent(double omega) const override {
    if (omega >= 2) return 1;
    const double g = value(omega);
    return 0.5 * (1 + g) * omega - 0.5 * omega * g;
  }
  /// scale ω + κ0 (1 − ω/2) = opening.
  double at_trial_opening(double opening, double scale, double kappa0) const override {
    if (opening >= scale * 2) return opening / scale;
    return std::max((opening - kappa0) / (scale - kappa0 / 2), 0.0);
  }
  /// ω/(1 − ω/2) = y  →  ω = y/(1 + y/2).
  double at_same_compliance(double omega, double ratio) const override {
    if (omega >= 2) return omega;
    const double y = ratio * omega / value(omega);
    return y / (1 + y / 2);
  }
};

Schema<SofteningParameters> schema() {
  return softening_schema("Linear softening, from a plugin: an example.");
}

std::unique_ptr<InterfaceLaw> make(const SofteningParameters& p) {
  return std::make_unique<DamageLaw>(p.numbers(), std::make_unique<StraightShape>());
}

}  // namespace

DDA_REGISTER(interface_laws(), "straight_softening", schema(), make);

}  // namespace dda
