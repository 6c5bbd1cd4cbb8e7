#pragma once

#include <memory>

#include "models/interface/coulomb.hpp"
#include "models/interface/law.hpp"
#include "models/interface/softening/softening_shape.hpp"

namespace dda {

/// Numbers of a softening joint, whatever its curve.
struct SofteningNumbers {
  double strength = 0;               ///< ft [F/L²]
  double fracture_energy = 0;        ///< Gf of pure opening [F/L]
  double shear_fracture_energy = 0;  ///< Gf_II of pure sliding [F/L]
  double mixed_mode_exponent = 1;    ///< η
  double shear_weight = 1;           ///< β = cohesion/ft
  double friction = 0;               ///< tan φ
};

/// A law that softens by scalar damage and unloads to the origin, with Coulomb friction on what is damaged.
///
///     x    = sign(q_s) ⟨|q_s| − m ⟨−q_n⟩⟩,   m = tan φ/β²      sliding beyond what friction alone holds
///     q_eq = √(⟨q_n⟩² + (β x)²),   κ = max(h.κ, q_eq),   κ0 = ft/k
///     r    = t_eq(κ)/κ                                       secant; k where intact, damage 1 − r/k
///     e    = clip(q_s − s, ± m ⟨−q_n⟩)                        friction, s the slip
///     t_n  = r ⟨q_n⟩ − k ⟨−q_n⟩,   t_s = β² (r q_s + (k − r) e)
///     ψ    = ½ r (⟨q_n⟩² + β² q_s²) + ½ k ⟨−q_n⟩² + ½ (k − r) β² e²
///
/// So a closed joint starts to slide at |t_s| = c − t_n tan φ, c = β ft (Mohr-Coulomb), and ends at pure
/// friction; without friction, and with one fracture energy, the law has a potential and D is symmetric. The
/// curve is t_eq = ft g(w ft/Gf), w the physical opening: κ = w + t_eq/k.
///
/// Mixed mode (Benzeggagh and Kenane): Gf(M) = Gf + (Gf_II − Gf) M^η, M = (β x/q_eq)² the share of sliding in
/// the energy. κ is then the opening of pure mode I with the same damage, so that changing the mode never
/// heals.
///
/// Energy spent: ∫ ½ k q_eq² d(damage) + ∫ β² k e d(damage s), the first in closed form at fixed mode,
/// averaged over the modes of both ends, the second with the mean e along the straight line of the step.
class DamageLaw final : public InterfaceLaw {
 public:
  DamageLaw(const SofteningNumbers& numbers, std::unique_ptr<SofteningShape> shape);

  std::vector<Remembered> memory() const override;
  double shear_weight() const override { return n_.shear_weight; }
  double steepest_slope() const override;
  bool can_crack() const override { return true; }
  double initial_kappa(double k) const override { return n_.strength / k; }
  double intact_bound(const History& h, double k) const override {
    return kappa(h, k) > initial_kappa(k) ? 0 : initial_kappa(k);
  }
  double kappa(const History& h, double k) const override;
  double rupture_kappa(double) const override { return scale_ * shape_->end(); }
  bool is_spent(const History& h, double k) const override {
    constexpr double next_to_nothing = 1e-6;
    return is_broken(h, k) || shape_->value(kappa(h, k) / scale_) <= next_to_nothing;
  }
  double next_corner(const History& h, double k) const override;
  double equivalent_opening(const Vec2& q, const History& h, double k) const override;
  Vec2 opening_gradient(const Vec2& q, const History& h, double k) const override;
  Vec2 slip_gradient(const Vec2& q, const History& h, double k) const override;
  Response respond(const Vec2& q, const History& h, double k) const override;
  Response respond_frozen(const Vec2& q, const History& h, double k) const override;
  Response respond_bounded(const Vec2& q, const History& h, double k, double closing) const override;
  Spending spending(const Vec2& q, const History& h, double k) const override;
  History accept(const Vec2& q, const History& h, double k) const override;
  double stored(const Vec2& q, const History& h, double k) const override;
  double damage(const History& h, double k) const override { return damage_at(kappa(h, k), k); }
  History grown(const History& h, double k, double factor) const override;
  unsigned piece(const Vec2& q, const History& h, double k) const override;
  std::optional<Contact> contact(const History& h, double k) const override;
  std::optional<Widening> widening(double kappa, double k) const override;
  std::optional<double> residual_friction() const override {
    return n_.friction > 0 ? std::optional(n_.friction) : std::nullopt;
  }

 private:
  /// q as the damage sees it.
  struct Trial {
    double opening = 0;  ///< q_eq
    double mixity = 0;   ///< M
    Vec2 opening_gradient = Vec2::Zero(), mixity_gradient = Vec2::Zero();
  };
  /// The opening of pure mode I with the same damage.
  struct Equivalent {
    double kappa = 0, mixity = 0;
    Vec2 gradient = Vec2::Zero(), mixity_gradient = Vec2::Zero();
  };
  Trial trial(const Sides& at) const;
  Equivalent equivalent(const Sides& at, double k) const;
  bool is_loading(double opening, double kappa, bool flag) const;
  Friction friction(const Sides& at, const History& h) const;
  Response secant(const Sides& at, const History& h, double kappa, double k) const;
  Response responded(const Sides& at, const History& h, double k) const;
  void add_friction_work(const Vec2& q, const History& h, double k, Spending& out) const;

  bool has_modes() const { return n_.shear_fracture_energy != n_.fracture_energy; }
  double energy_ratio(double mixity) const;        ///< ρ = Gf(M)/Gf
  double energy_ratio_slope(double mixity) const;  ///< dρ/dM
  double largest_gain() const;                     ///< no less than ∂κ/∂q_n
  double omega_at(double kappa, double k) const {
    return shape_->at_trial_opening(kappa, scale_, initial_kappa(k));
  }
  double secant_at(double kappa, double k) const;  ///< r
  double secant_slope_at(double kappa, double k) const;
  double damage_at(double kappa, double k) const { return 1 - secant_at(kappa, k) / k; }
  /// Energy spent up to κ in a mode, its derivatives with respect to κ and M.
  struct Spent {
    double value = 0, per_kappa = 0, per_mixity = 0;
  };
  Spent spent(double kappa, double mixity, double k) const;
  struct Growth {
    double from = 0, to = 0;
  };
  double growth_energy(const Growth& kappa, double mixity, const History& h, double k) const;

  SofteningNumbers n_;
  std::unique_ptr<SofteningShape> shape_;
  double scale_;  ///< Gf/ft [L]
  double m_;      ///< tan φ/β²
};

}  // namespace dda
