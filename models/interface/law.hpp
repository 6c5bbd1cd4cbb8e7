#pragma once

#include <memory>
#include <optional>

#include "framework/deck/family.hpp"
#include "models/interface/law_memory.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// What an interface point remembers of the last accepted step: what a path must know of every law, and what
/// the point's own law alone can read.
struct History {
  bool loading = false;   ///< the point sits on its damage surface and the path leaves it by loading
  bool sliding = false;   ///< its friction is exhausted and the path leaves it by sliding
  double share = 0;       ///< of what is being released that is still carried, from 1 down to 0
  double dissipated = 0;  ///< energy spent so far per area [F/L]
  LawMemory memory;       ///< the law's own

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("loading", self.loading);
    visit("sliding", self.sliding);
    visit("share", self.share);
    visit("dissipated", self.dissipated);
    visit("memory", self.memory.numbers());
  }
};

/// Traction and tangent of one interface point in its local frame (n, s).
struct Response {
  Vec2 traction = Vec2::Zero();  ///< t [F/L²]
  Mat2 tangent = Mat2::Zero();   ///< ∂t/∂q [F/L³]
};

/// Energy per area that a point spends beyond its history, and its derivative with respect to q.
struct Spending {
  double value = 0;              ///< [F/L]
  Vec2 gradient = Vec2::Zero();  ///< [F/L²]
};

/// The opening of a crack by pure opening, and its derivative with respect to κ.
struct Widening {
  double opening = 0;  ///< w [L]
  double slope = 1;    ///< dw/dκ
  double gain = 1;     ///< no less than ∂κ/∂q_n anywhere
};

/// A joint whose damage stays: piecewise linear in q.
///
///     closed, x ≤ 0:  t_n = closed x − p,   t_s = shear q_s + friction e,   e = clip(q_s − slip, ± m ⟨−x⟩)
///     open,   x > 0:  t_n = open x − p,     t_s = shear q_s,                x = q_n + shift
struct Contact {
  double closed = 0;       ///< [F/L³]
  double open = 0;         ///< [F/L³]
  double shear = 0;        ///< of what is not broken [F/L³]
  double friction = 0;     ///< of what is [F/L³]
  double coefficient = 0;  ///< m
  double slip = 0;         ///< s [L]
  double pressure = 0;     ///< p of water in the joint [F/L²]
  double shift = 0;        ///< what p opens the joint's own spring by, p/k [L]
};

/// What an interface does with the trial opening q of its two sides, in the local frame (n, s).
///
///     t = law(q; h)             traction, size 2                    [F/L²]
///     D = ∂t/∂q                 tangent, 2 × 2, symmetric unless frictional   [F/L³]
///     intact: t = D0 q,         D0 = P = k diag(1, β²) unless the joint itself is soft
///
/// q = (q_n, q_s) [L], q_n > 0 opens. A law is "rigid until strength, then ..." in series with the numerical
/// compliance P⁻¹ of the treatment: its physical opening is w = q − P⁻¹ t. The stiffness k belongs to the
/// point and is passed to every function; the history h is that of the last accepted step and never changes
/// inside a solve. Source: models/README.md.
class InterfaceLaw {
 public:
  virtual ~InterfaceLaw() = default;

  /// What it remembers of a point beside what a path must know: `declared<Memory>()` of the law's record.
  virtual std::vector<Remembered> memory() const { return {}; }

  /// β, ratio of the shear to the normal trial stiffness: P = k diag(1, β²).
  virtual double shear_weight() const { return 1; }
  /// Diagonal of D0 [F/L³].
  virtual Vec2 intact_stiffness(double k) const { return {k, k * shear_weight() * shear_weight()}; }
  /// Largest slope −dt/dw of the softening branch [F/L³]; k must exceed it. Zero for laws that do not soften.
  virtual double steepest_slope() const { return 0; }
  /// Whether the point can ever leave its intact state; otherwise t = D0 q always.
  virtual bool can_crack() const = 0;

  /// κ at which an intact point of stiffness k reaches its strength [L]; infinite when it never does.
  virtual double initial_kappa(double k) const = 0;
  /// A bound below which a point that has spent nothing answers as an intact one, so that it need not be
  /// asked [L]:
  ///
  ///     ⟨q_n⟩² + β² q_s² < bound²   ⇒   t = D0 q, nothing spent
  ///
  /// 0 where a law has none, or none any more.
  virtual double intact_bound(const History&, double) const { return 0; }
  /// κ at which the traction has vanished [L]; infinite when that is nowhere.
  virtual double rupture_kappa(double k) const = 0;
  /// κ of the next corner of the softening curve beyond the history's, at the latest that of rupture [L].
  virtual double next_corner(const History&, double k) const { return rupture_kappa(k); }
  /// κ of a history, at least that of initiation: what the equivalent opening must reach for more to crack
  /// [L].
  virtual double kappa(const History&, double k) const { return initial_kappa(k); }
  /// Whether nothing is left that could crack.
  virtual bool is_broken(const History& h, double k) const { return kappa(h, k) >= rupture_kappa(k); }
  /// Whether so little is left that the bodies it joins part freely: of a law whose traction never vanishes less than
  /// a millionth of its strength.
  virtual bool is_spent(const History& h, double k) const { return is_broken(h, k); }
  /// Equivalent trial opening [L], to be compared with κ.
  virtual double equivalent_opening(const Vec2& q, const History& h, double k) const = 0;
  /// Its derivative with respect to q, size 2.
  virtual Vec2 opening_gradient(const Vec2& q, const History& h, double k) const = 0;
  /// Rate of |friction traction| over its limit per rate of q where friction is exhausted, size 2; zero
  /// elsewhere.
  virtual Vec2 slip_gradient(const Vec2&, const History&, double) const { return Vec2::Zero(); }

  /// Traction and consistent tangent at q. On a surface the history's flags choose the side.
  virtual Response respond(const Vec2& q, const History& h, double k) const = 0;
  /// Traction and stiffness at q with the damage of h frozen; contact and friction still follow q.
  virtual Response respond_frozen(const Vec2& q, const History& h, double k) const = 0;
  /// The same with friction bounded by a given closing whatever q is, in place of ⟨−q_n⟩: while the sides are pressed
  /// together D is symmetric. Of laws without friction, and of water, which follows q, it is `respond`.
  virtual Response respond_bounded(const Vec2& q, const History& h, double k, double) const {
    return respond(q, h, k);
  }
  /// Energy per area that accepting q would add to h.dissipated.
  virtual Spending spending(const Vec2& q, const History& h, double k) const = 0;
  /// The history after q has been accepted.
  virtual History accept(const Vec2& q, const History& h, double k) const = 0;
  /// Energy per area stored in the trial spring, ψ(q; h) [F/L].
  virtual double stored(const Vec2& q, const History& h, double k) const = 0;
  /// Lost share of the secant stiffness, 0 intact to 1 released.
  virtual double damage(const History& h, double k) const = 0;
  /// The history with the damage grown by a factor of κ, for sequentially linear steps.
  virtual History grown(const History& h, double, double) const { return h; }
  /// Which smooth piece of the law q lies on, as a small number; 0 for the intact piece.
  virtual unsigned piece(const Vec2&, const History&, double) const { return 0; }

  /// The joint with the damage of h, where that makes it piecewise linear; nothing where q decides more, and
  /// of joints that are still intact.
  virtual std::optional<Contact> contact(const History&, double) const { return {}; }

  /// The opening that a damage of κ amounts to; nothing of laws that do not tell.
  virtual std::optional<Widening> widening(double, double) const { return {}; }
  /// Energy per area that water in the joint has supplied so far [F/L].
  virtual double supplied(const History&) const { return 0; }
  /// Pressure of water in the joint [F/L²].
  virtual double water_pressure(const History&, double) const { return 0; }

  /// tan φ of what nothing but contact is left of; nothing where the law says nothing about it.
  virtual std::optional<double> residual_friction() const { return {}; }

  /// Whether a point at its strength loses it at once instead of softening (see
  /// continuation/detour/release.hpp).
  virtual bool releases_at_once() const { return false; }
  /// The history in which a point at q has `share` of what it is losing left; accepting it books the energy.
  virtual History release(const Vec2&, const History& h, double, double) const { return h; }
  /// Direction c whose component c·q stays while the point is released, size 2.
  virtual Vec2 held_direction(const Vec2&, const History&) const { return Vec2::Zero(); }
};

using LawFamily = Family<InterfaceLaw>;
using LawChoice = Choice<InterfaceLaw>;

/// The registry of interface laws.
LawFamily& interface_laws();

}  // namespace dda
