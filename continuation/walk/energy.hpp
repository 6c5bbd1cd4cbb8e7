#pragma once

#include "continuation/walk/tangent.hpp"

namespace dda {

/// The displacement on which the load works: their product is the work per load factor.
Functional displacement_of_load(const Loading& loading);

/// External work of a step, integrated from forces and displacements alone (never from the energies it is
/// compared with): ∫ F du by cubic Hermite interpolation of both with the path's tangents, exact on straight
/// steps.
///
/// `step` is the parameter of both tangents over the step (dissipated energy); 0 uses the trapezoid.
double external_work(const System& system, const State& from, const State& to, const Tangent& leaving,
                     const Tangent& arriving, double step);

}  // namespace dda
