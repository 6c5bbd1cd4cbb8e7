#pragma once

#include "models/interface/law.hpp"

namespace dda {

/// A point's law with what it knows.
struct LawAt {
  const InterfaceLaw& law;
  const History& history;
  double stiffness = 0;  ///< k [F/L³]

  double kappa() const { return law.kappa(history, stiffness); }
  double opening(const Vec2& q) const { return law.equivalent_opening(q, history, stiffness); }
  Vec2 gradient(const Vec2& q) const { return law.opening_gradient(q, history, stiffness); }
};

/// Smallest x in (0, ∞) at which the equivalent opening of q = a + x b rises through κ; infinite when it
/// never does.
///
/// Between the places where q_n or q_s change sign the opening is convex in x: Newton from the right end of
/// each such stretch converges monotonically, guarded by bisection.
double reach(const LawAt& point, const Vec2& a, const Vec2& b);

/// Share of the straight way from one opening to another at which the equivalent opening rises through κ; 1
/// when it ends at most `round_off` beyond, and for a broken point.
double share_to_kappa(const LawAt& point, const Vec2& from, const Vec2& to, double round_off);

}  // namespace dda
