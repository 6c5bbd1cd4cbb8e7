#pragma once

#include <algorithm>

#include "models/kinematics/first_order.hpp"

namespace dda {

/// Of the limit of friction: what is beyond it by more than rounding slides; what has been told to slide on does so from a
/// little below it, as near as a step is solved.
inline constexpr double beyond_limit = 1e-11, at_limit_from = 1e-7;

/// ⟨−q_n⟩.
inline double closing_of(const Vec2& q) { return std::max(0.0, -q.x()); }

/// Where the sides of a point are, and the closing that bounds their friction: their own, ⟨−q_n⟩, or a given one whatever
/// q_n is, as where normal forces are those of an iterate before.
struct Sides {
  Vec2 q;
  double closing;     ///< [L]
  double per_normal;  ///< its derivative with respect to q_n

  Sides(const Vec2& at)  // NOLINT(google-explicit-constructor): an opening is where the sides are
      : q(at), closing(closing_of(at)), per_normal(at.x() > 0 ? 0 : -1) {}
  Sides(const Vec2& at, double given) : q(at), closing(given), per_normal(0) {}

  /// Touching, q_n = 0, counts as closed.
  bool rub() const { return closing > 0 || per_normal < 0; }
};

/// Coulomb friction of a part of a point that carries no cohesion any more, as an elastic-perfectly plastic
/// spring under the contact pressure.
///
///     e = clip(q_s − s, ± m c),   c = ⟨−q_n⟩,   m = tan φ/β²,   friction traction β² k e,   new slip s = q_s − e
struct Friction {
  double elastic = 0;            ///< e [L]
  Vec2 gradient = Vec2::Zero();  ///< ∂e/∂q
  bool slides = false;           ///< e is at its limit
  bool at_limit = false;         ///< nearer to the limit than a step is solved, whichever side was chosen
  double direction = 0;          ///< sign of q_s − s
};

/// Sliding on the straight line of a step from q⁰ to q¹, slip s at its start, d the sign of what slides:
///
///     g(θ) = d (q_s − s) + m q_n      beyond the limit where positive, linear in θ
///     θ*                              onset of sliding: g = 0, at the earliest where the sides touch
///     energy = ½ m [p(θ*) + p(θ_b)] · g(θ_b),   p = −q_n,   θ_b = 1 or where the sides part
///
/// times β² k is what friction dissipates, exact along that line whether it sticks first, slides all the way
/// or turns round; nothing is paid while the sides are apart.
struct LineSlide {
  double energy = 0;             ///< [L²]
  Vec2 gradient = Vec2::Zero();  ///< its derivative with respect to q¹ [L]
  double mean = 0;               ///< signed mean of e while sliding [L]
  Vec2 mean_gradient = Vec2::Zero();
};
LineSlide slide_along(const Vec2& from, const Vec2& to, double slip, double m);

/// The same at the start of a step, for what is at its limit and slides on: no energy yet, and its derivative
/// on the side of sliding.
LineSlide slide_on(const Vec2& at, double slip, double m);

/// Sliding on the straight line of a step under a limit L that changes by itself, straight as well: x is what
/// the spring would bear if nothing slid on, d the sign of its end.
///
///     g(θ) = d x − L              beyond the limit where positive, linear in θ
///     θ*                          onset of sliding: g = 0
///     energy = ½ [L(θ*) + L(1)] · (g(1) − ⟨g(0)⟩)
///
/// over the stiffness is what is dissipated, never negative and exact along that line.
struct Course {
  double from = 0, to = 0;  ///< [F/L²]
};
struct LimitedSlide {
  double energy = 0;     ///< [F²/L⁴]
  double per_trial = 0;  ///< its derivative with respect to x at the end [F/L²]
  double per_limit = 0;  ///< and to L at the end
};
LimitedSlide slide_under(const Course& limit, const Course& trial);

/// At the limit `sliding` decides which side's gradient is meant.
Friction coulomb_friction(const Sides& at, double slip, bool sliding, double m);

}  // namespace dda
