#pragma once

#include "continuation/follow/path_state.hpp"

namespace dda {

// Steps that no control leads along.

/// Sequentially linear steps until at least `quantum` has been dissipated; the log calls them a rescue unless
/// it is one to an event.
std::optional<Point> sequential_step(PathState& path, StepKind kind, double quantum);

/// The largest of some steps of the displacement on which the load works that ends in an equilibrium, what is
/// beyond its strength there released at once: a path through contacts that change is not found by its
/// tangent.
std::optional<Point> driven_step(PathState& path);

/// The end where nothing is found any more: rupture if hardly any load is left.
std::optional<Point> end_without_equilibrium(PathState& path, const std::string& why);

}  // namespace dda
