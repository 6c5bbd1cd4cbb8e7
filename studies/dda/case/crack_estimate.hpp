#pragma once

#include "models/equilibrium.hpp"

namespace dda {

/// Interface points of one crack through half of a square, on both of its sides, where everything may crack:
///
///     points / √blocks
double points_of_one_crack(const Equilibrium& equilibrium);

/// How many are likely to crack there, without following the path: those of one crack and those that soften
/// beside it.
///
///     points / √blocks · (1 + l_p / 2h),     l_p = π/8 l_ch,     l_ch = E Gf / ft²
///
/// l_p is the length of a process zone of constant traction, h the distance of the blocks, l_ch the mean over
/// the points. Where strength is lost at once only the crack counts.
double likely_cracks(const Equilibrium& equilibrium);

}  // namespace dda
