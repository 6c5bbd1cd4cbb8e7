#pragma once

#include "models/interface/law.hpp"

namespace dda {

/// A law that softens by scalar damage and unloads to the origin, in trial form.
///
///     q_eq = √(⟨q_n⟩² + (β q_s)²),   κ = max(h.κ, q_eq)
///     t_n = r(κ) q_n,  t_s = β² r(κ) q_s,   r(κ) = t_eq(κ)/κ  (r = k intact)
///     q_n < 0:  t_n = k q_n  (contact keeps the full stiffness)
///     ψ = ½ k ⟨−q_n⟩² + ψ_soft(κ), so mixed mode, unloading and contact are variational and D is symmetric
///
/// A member writes the curve t_eq(κ), its slope and G(κ); everything else is here.
/// Source: models/README.md.
class DamageLaw : public InterfaceLaw {
 public:
  explicit DamageLaw(double shear_weight) : beta_(shear_weight) {}

  double shear_weight() const final { return beta_; }
  bool can_crack() const final { return true; }
  double equivalent_opening(const Vec2& q) const final;
  Vec2 opening_gradient(const Vec2& q) const final;
  Response respond(const Vec2& q, const History& h, double k) const final;
  Response respond_frozen(const Vec2& q, const History& h, double k) const final;
  double damage(double kappa, double k) const final;

 protected:
  /// t_eq(κ) for κ ≥ κ0 [F/L²].
  virtual double strength(double kappa, double k) const = 0;
  /// dt_eq/dκ for κ ≥ κ0 [F/L³].
  virtual double strength_slope(double kappa, double k) const = 0;

 private:
  Response secant(const Vec2& q, double kappa, double k) const;
  bool is_loading(double opening, double kappa, bool flag) const;

  double beta_;
};

}  // namespace dda
