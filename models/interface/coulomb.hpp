#pragma once

#include "models/kinematics/first_order.hpp"

namespace dda {

/// Coulomb friction of a part of a point that carries no cohesion any more, as an elastic-perfectly plastic
/// spring under the contact pressure.
///
///     e = clip(q_s − s, ± m ⟨−q_n⟩),   m = tan φ/β²,   friction traction β² k e,   new slip s = q_s − e
struct Friction {
  double elastic = 0;            ///< e [L]
  Vec2 gradient = Vec2::Zero();  ///< ∂e/∂q
  bool slides = false;           ///< e is at its limit
  bool at_limit = false;         ///< within round-off of the limit, whichever side was chosen
  double direction = 0;          ///< sign of q_s − s
};

/// Traction under which a step slid, as far as both of its ends tell: their mean when it slid from its start
/// or ends with less than it began with, else that of its end (it stuck at first, or turned round), none
/// where that is unknown. So sliding never gains energy.
struct SlidingTraction {
  double mean = 0;     ///< [F/L²]
  double per_now = 0;  ///< its derivative with respect to the traction at the end
};
SlidingTraction sliding_traction(double before, double now, double slipped, bool slid_before);

/// At the limit `sliding` decides which side is meant. Touching, q_n = 0, counts as closed.
Friction coulomb_friction(const Vec2& q, double slip, bool sliding, double m);

}  // namespace dda
