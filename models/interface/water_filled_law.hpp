#pragma once

#include <memory>

#include "models/interface/law.hpp"

namespace dda {

/// Another law on whose crack water of pressure p presses both faces apart, as far as it has come in.
///
///     t = t₀(q + c n) − P n,    P = p s(w),    c = P/k,    s = min(w/w_f, 1)
///
/// w is the opening by pure opening that the damage amounts to, so that what has been filled stays filled where the crack
/// closes again; w_f that at which the pressure is whole. The law of the solid sees its own traction t₀, and the physical
/// opening q − t/k is the same for both. P depends on q where the damage grows, by a single equation:
///
///     c = (p/k) s(w(κ(q + c n))),    ∂c/∂q = b a/(1 − b a_n),    b = (p/k) s' dw/dκ,    a = ∂κ/∂q
///
/// with one solution for k above the steepest slope p/w_f + that of t₀. Between bodies that only touch there is no damage: water is
/// there from the beginning, P = p, c = p/k, whether they touch or not. The water does the work ∫ P dw_n [F/L], by
/// trapezoids from history to history, which is exact where damage grows along a straight line of t₀ and w_n.
class WaterFilledLaw final : public InterfaceLaw {
 public:
  /// `pressure` p > 0 [F/L²]; `opening` w_f > 0 [L] of a law that tells its `widening`, else it says nothing.
  WaterFilledLaw(std::shared_ptr<const InterfaceLaw> law, double pressure, double opening);

  std::vector<Remembered> memory() const override;
  double shear_weight() const override { return law_->shear_weight(); }
  Vec2 intact_stiffness(double k) const override { return law_->intact_stiffness(k); }
  double steepest_slope() const override {
    return law_->steepest_slope() + (is_crack_ ? law_->widening(0, 1)->gain * full_ / opening_ : 0);
  }
  bool can_crack() const override { return law_->can_crack(); }

  double initial_kappa(double k) const override { return law_->initial_kappa(k); }
  double intact_bound(const History& h, double k) const override { return law_->intact_bound(h, k); }
  double rupture_kappa(double k) const override { return law_->rupture_kappa(k); }
  double next_corner(const History& h, double k) const override;
  double kappa(const History& h, double k) const override { return law_->kappa(h, k); }
  bool is_broken(const History& h, double k) const override { return law_->is_broken(h, k); }
  bool is_spent(const History& h, double k) const override { return law_->is_spent(h, k); }
  double equivalent_opening(const Vec2& q, const History& h, double k) const override;
  Vec2 opening_gradient(const Vec2& q, const History& h, double k) const override;
  Vec2 slip_gradient(const Vec2& q, const History& h, double k) const override;

  Response respond(const Vec2& q, const History& h, double k) const override;
  Response respond_frozen(const Vec2& q, const History& h, double k) const override;
  Spending spending(const Vec2& q, const History& h, double k) const override;
  History accept(const Vec2& q, const History& h, double k) const override;
  double stored(const Vec2& q, const History& h, double k) const override;
  double damage(const History& h, double k) const override { return law_->damage(h, k); }
  History grown(const History& h, double k, double factor) const override;
  unsigned piece(const Vec2& q, const History& h, double k) const override;
  std::optional<Contact> contact(const History& h, double k) const override;
  std::optional<double> residual_friction() const override { return law_->residual_friction(); }
  std::optional<Widening> widening(double kappa, double k) const override { return law_->widening(kappa, k); }
  double supplied(const History& h) const override;
  double water_pressure(const History& h, double k) const override;

 private:
  /// Pressure at κ and its derivative.
  struct Filling {
    double pressure = 0, slope = 0;
  };
  Filling at(double kappa, double k) const;
  /// What the water adds to the opening that the law of the solid sees.
  struct Shift {
    double c = 0;                  ///< [L]
    Vec2 gradient = Vec2::Zero();  ///< ∂c/∂q
    Vec2 of(const Vec2& q) const { return {q.x() + c, q.y()}; }
    /// What depends on q + c n, as it depends on q.
    Vec2 chained(const Vec2& g) const { return g + g.x() * gradient; }
  };
  Shift shift(const Vec2& q, const History& h, double k) const;
  double solved(const Vec2& q, const History& h, double k, double least) const;
  /// Of the water that is there.
  Shift frozen(const History& h, double k) const;

  std::shared_ptr<const InterfaceLaw> law_;
  bool is_crack_;  ///< else bodies that only touch
  double full_, opening_;
  std::size_t behind_;  ///< numbers that the law of the solid remembers
};

}  // namespace dda
