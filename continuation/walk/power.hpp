#pragma once

#include "continuation/walk/tangent.hpp"

namespace dda {

/// Energy spent per unit of load factor where cracks grow, friction included; 0 when none grows.
double dissipation_rate(System& system, const State& state, const Tangent& along);

/// What the live loads do along a direction: forces per unit of their factor, and the size of what all do
/// with them now.
struct LivePower {
  double of_forces = 0, size = 0;
};

LivePower live_power(const System& system, const State& state, const Tangent& along);

}  // namespace dda
