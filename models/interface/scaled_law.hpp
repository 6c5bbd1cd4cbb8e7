#pragma once

#include <limits>
#include <memory>

#include "models/interface/law.hpp"

namespace dda {

/// Another law with all its tractions a times and all its physical openings b times as large.
///
///     t = a t₀(q/b; k₀),   k₀ = k b/a        D = (a/b) D₀
///     strengths × a,   fracture energies × a b,   slopes × a/b,   β and tan φ as they are
///
/// Exact for every law: q = w + t/k gives q/b = w/b + (t/a)/k₀, the trial opening of the law at w/b. The
/// stiffness k stays the treatment's. A history is the other law's own, but for the energy: what is compared
/// with κ₀ is never rounded.
class ScaledLaw final : public InterfaceLaw {
 public:
  ScaledLaw(std::shared_ptr<const InterfaceLaw> law, double traction, double opening)
      : law_(std::move(law)), a_(traction), b_(opening) {}

  std::vector<Remembered> memory() const override { return law_->memory(); }
  double shear_weight() const override { return law_->shear_weight(); }
  Vec2 intact_stiffness(double k) const override { return a_ / b_ * law_->intact_stiffness(own(k)); }
  double steepest_slope() const override { return a_ / b_ * law_->steepest_slope(); }
  bool can_crack() const override { return law_->can_crack(); }

  double initial_kappa(double k) const override { return b_ * law_->initial_kappa(own(k)); }
  double intact_bound(const History& h, double k) const override {
    return b_ * law_->intact_bound(h, own(k));
  }
  /// Rounded up: what reaches it is broken.
  double rupture_kappa(double k) const override {
    return b_ * law_->rupture_kappa(own(k)) * (1 + 4 * std::numeric_limits<double>::epsilon());
  }
  double next_corner(const History& h, double k) const override { return b_ * law_->next_corner(h, own(k)); }
  double kappa(const History& h, double k) const override { return b_ * law_->kappa(h, own(k)); }
  bool is_broken(const History& h, double k) const override { return law_->is_broken(h, own(k)); }
  bool is_spent(const History& h, double k) const override { return law_->is_spent(h, own(k)); }
  double equivalent_opening(const Vec2& q, const History& h, double k) const override {
    return b_ * law_->equivalent_opening(q / b_, h, own(k));
  }
  Vec2 opening_gradient(const Vec2& q, const History& h, double k) const override {
    return law_->opening_gradient(q / b_, h, own(k));
  }
  Vec2 slip_gradient(const Vec2& q, const History& h, double k) const override {
    return law_->slip_gradient(q / b_, h, own(k));
  }

  Response respond(const Vec2& q, const History& h, double k) const override {
    return scaled(law_->respond(q / b_, h, own(k)));
  }
  Response respond_frozen(const Vec2& q, const History& h, double k) const override {
    return scaled(law_->respond_frozen(q / b_, h, own(k)));
  }
  Response respond_bounded(const Vec2& q, const History& h, double k, double closing) const override {
    return scaled(law_->respond_bounded(q / b_, h, own(k), closing / b_));
  }
  Spending spending(const Vec2& q, const History& h, double k) const override {
    const Spending found = law_->spending(q / b_, h, own(k));
    return {a_ * b_ * found.value, a_ * found.gradient};
  }
  History accept(const Vec2& q, const History& h, double k) const override {
    History out = law_->accept(q / b_, h, own(k));
    out.dissipated = h.dissipated + spending(q, h, k).value;
    return out;
  }
  double stored(const Vec2& q, const History& h, double k) const override {
    return a_ * b_ * law_->stored(q / b_, h, own(k));
  }
  double damage(const History& h, double k) const override { return law_->damage(h, own(k)); }
  History grown(const History& h, double k, double factor) const override {
    History out = law_->grown(h, own(k), factor);
    out.dissipated = h.dissipated + a_ * b_ * (out.dissipated - h.dissipated);
    return out;
  }
  unsigned piece(const Vec2& q, const History& h, double k) const override {
    return law_->piece(q / b_, h, own(k));
  }

  std::optional<Contact> contact(const History& h, double k) const override {
    std::optional<Contact> out = law_->contact(h, own(k));
    if (!out) return out;
    for (double* stiffness : {&out->closed, &out->open, &out->shear, &out->friction}) *stiffness *= a_ / b_;
    out->slip *= b_;
    return out;
  }

  std::optional<double> residual_friction() const override { return law_->residual_friction(); }
  std::optional<Widening> widening(double kappa, double k) const override {
    std::optional<Widening> out = law_->widening(kappa / b_, own(k));
    if (out) out->opening *= b_;
    return out;
  }

  bool releases_at_once() const override { return law_->releases_at_once(); }
  History release(const Vec2& q, const History& h, double k, double share) const override {
    return law_->release(q / b_, h, own(k), share);
  }
  Vec2 held_direction(const Vec2& q, const History& h) const override {
    return law_->held_direction(q / b_, h);
  }

 private:
  double own(double k) const { return k * (b_ / a_); }
  Response scaled(const Response& r) const { return {a_ * r.traction, a_ / b_ * r.tangent}; }

  std::shared_ptr<const InterfaceLaw> law_;
  double a_, b_;
};

}  // namespace dda
