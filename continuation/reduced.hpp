#pragma once

#include <optional>

#include "continuation/control/control.hpp"

namespace dda {

/// What Newton's method on the cracked points alone has found.
struct Reduced {
  State state;
  int iterations = 0;
};

/// Newton's method on the cracked points alone, everything else being linear.
///
///     q = q_dead + λ q_ref − G z,     z = W (t(q; h) − D_base q),     N(q, λ) = 0
///     d = d_dead + λ d_ref − Z z
///
/// with the base, Z and G of LinearSystem; an iteration costs a dense solve of the size of the cracked
/// components. The state that is found is looked at in full: points that crack there are taken in and the
/// iteration starts again from the guess, so that it goes the way of Newton's method for all unknowns. It is
/// a better guess and no more: equilibrium is judged by the full residual. Nothing where no base is kept,
/// under controls that look at every point, with initial stress or iterated multipliers, and where the
/// iteration does not converge.
std::optional<Reduced> solve_reduced(System& system, const Control& control, double s, const State& guess,
                                     int max_iterations);

}  // namespace dda
