#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

// How long the next step is.

/// The first step after a crack: small against the load and against what the fastest point may still open;
/// where dead loads have cracked and there is no load yet, against the way to the next crack.
double first_amount(const PathState& path);
/// That, or what the deck wants of the first step under a control.
double first_amount(const PathState& path, const Move& move);

/// What a step is measured in, per unit of the leaving tangent: the control's own quantity. Where cracks grow
/// both are energies; elsewhere the tangent's unit, the load factor, may all but stand still.
double unit_of(const PathState& path, const Move& move);

/// How far a first step goes where contacts alone change, the nearest change being no measure: it may lie
/// next to nothing ahead.
double sliding_amount(const PathState& path);

/// No step may be predicted to change load or displacement by more than the deck allows, nor be longer.
double bounded(const PathState& path, const Move& move, double amount);

/// What is tried for a step of which only a share is left: more, which takes long, once cuts have not helped.
Thoroughness thoroughness_of(double share);

/// The next step, by `path.step.sizing`.
void resize(PathState& path, const Candidate& candidate, double amount, const Move& move);

}  // namespace dda
