#pragma once

#include "models/interface/law.hpp"

namespace dda {

/// Largest x in (0, ∞) at which the equivalent opening of q = a + x b reaches κ; infinite when it never does.
///
/// q_eq is convex in x, so Newton from the right converges monotonically.
double reach(const InterfaceLaw& law, const Vec2& a, const Vec2& b, double kappa);

}  // namespace dda
