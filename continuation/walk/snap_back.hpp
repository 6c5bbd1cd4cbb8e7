#pragma once

#include <optional>

#include "continuation/walk/tangent.hpp"

namespace dda {

/// The direction of a path that snaps back where nothing cracks, as Coulomb friction allows: no rates with the live forces
/// keep the equilibrium, but joints slide on while the load falls and less and less is stored. History with the flags of the
/// step that led here; sets them as the direction needs. Nothing, and nothing changed, where there is no such direction.
std::optional<Tangent> snapping_tangent(System& system, const State& state, const Tangent& arriving);

}  // namespace dda
