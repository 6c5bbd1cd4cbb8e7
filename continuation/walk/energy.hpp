#pragma once

#include "continuation/walk/tangent.hpp"

namespace dda {

/// The displacement on which the load works, Σ f·u/Σ|f| over the blocks, u with the jumps that move a part of one [L].
Functional displacement_of_load(const Loading& loading, std::size_t num_blocks);

/// A step by its two ends and the tangents there. `length` is the parameter of both tangents over the step
/// (dissipated energy); 0 where they do not tell.
struct Stretch {
  const State& from;
  const State& to;
  const Tangent& leaving;
  const Tangent& arriving;
  double length = 0;
};

/// External work of a step, integrated from forces and displacements alone (never from the energies it is
/// compared with): ∫ F du by cubic Hermite interpolation of both with the path's tangents, exact on straight
/// steps. Without a length by the trapezoid.
double external_work(const System& system, const Stretch& step);

}  // namespace dda
