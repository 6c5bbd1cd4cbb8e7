#include <algorithm>

#include "models/interface/damage_law.hpp"

namespace dda {
namespace {

struct LinearSofteningParameters {
  double tensile_strength = 0;
  double fracture_energy = 0;
  double shear_weight = 1;
};

/// Linear softening: rigid until ft, then t = ft (1 − w/w_c) down to a stress-free crack, w_c = 2 Gf/ft.
///
///     w(κ) = (κ − κ0)/(1 − κ0/w_c),   κ0 = ft/k,   ruptured at κ = w_c
///     G(κ) = ½ ft w                    (secant unloading to the origin)
class LinearSoftening final : public DamageLaw {
 public:
  explicit LinearSoftening(const LinearSofteningParameters& p)
      : DamageLaw(p.shear_weight), ft_(p.tensile_strength), wc_(2 * p.fracture_energy / p.tensile_strength) {}

  double steepest_slope() const override { return ft_ / wc_; }
  double initial_kappa(double k) const override { return ft_ / k; }
  double rupture_kappa(double) const override { return wc_; }

  double dissipation(double kappa, double k) const override { return 0.5 * ft_ * opening(kappa, k); }
  double dissipation_slope(double kappa, double k) const override {
    return softens(kappa, k) ? 0.5 * ft_ / (1 - initial_kappa(k) / wc_) : 0;
  }

 private:
  double strength(double kappa, double k) const override { return ft_ * (1 - opening(kappa, k) / wc_); }
  double strength_slope(double kappa, double k) const override {
    return softens(kappa, k) ? -ft_ / wc_ / (1 - initial_kappa(k) / wc_) : 0;
  }
  bool softens(double kappa, double k) const { return kappa >= initial_kappa(k) && kappa < wc_; }
  /// w(κ), physical opening on the envelope [L], between 0 and w_c.
  double opening(double kappa, double k) const {
    if (kappa >= wc_) return wc_;
    return std::max(0.0, (kappa - initial_kappa(k)) / (1 - initial_kappa(k) / wc_));
  }

  double ft_, wc_;
};

Schema<LinearSofteningParameters> schema() {
  using P = LinearSofteningParameters;
  return Schema<P>(
             "Linear softening from the tensile strength to a stress-free crack, energy per area fixed.")
      .number("tensile_strength", &P::tensile_strength,
              {.dimension = dimension::stress,
               .bounds = above(0),
               .text = "Traction ft at which the interface starts to crack."})
      .number("fracture_energy", &P::fracture_energy,
              {.dimension = dimension::energy_per_area,
               .bounds = above(0),
               .text = "Energy Gf per area of a complete crack."})
      .number("shear_weight", &P::shear_weight,
              {.fallback = 1.0,
               .bounds = above(0),
               .text = "Weight β of sliding against opening in q_eq = sqrt(<q_n>² + (β q_s)²)."});
}

std::unique_ptr<InterfaceLaw> make(const LinearSofteningParameters& p) {
  return std::make_unique<LinearSoftening>(p);
}

}  // namespace

DDA_REGISTER(interface_laws(), "linear_softening", schema(), make);

}  // namespace dda
