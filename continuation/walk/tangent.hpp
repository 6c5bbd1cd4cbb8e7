#pragma once

#include <optional>
#include <vector>

#include "continuation/state/system.hpp"

namespace dda {

/// What a way along which no crack grows is to bring forward.
struct Heading {
  Functional gauge;
  double sign = 1;
};

/// Direction in which a path leaves (or reached) an equilibrium.
///
///     K ḋ = λ̇ ∂f/∂λ,  with the tangent of the points that load
///
/// Per unit of dissipated energy, that of friction included, when points load, so that its orientation is the
/// one that dissipates; per unit of load factor when nothing does, by its heading, or without one in the direction of
/// the live forces.
struct Tangent {
  Displacements d;
  double load_factor = 0;
  bool dissipates = false;  ///< a crack grows
  /// False where no rates were found that keep the equilibrium, whichever points grow, unload, slide and
  /// hold: some that rest along it would go on.
  bool keeps_equilibrium = true;
  std::vector<Vec2> multipliers;  ///< rates of iterated multipliers, else empty
  std::vector<Vec2> opening;      ///< q̇ of every active point

  /// Rate of a gauge along the direction; 0 of an empty one.
  double rate(const Functional& gauge) const {
    return d.empty() ? 0 : d.value(gauge, load_factor) - gauge.constant;
  }

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("load_factor", self.load_factor);
    visit("dissipates", self.dissipates);
    visit("keeps_equilibrium", self.keeps_equilibrium);
    visit("multipliers", self.multipliers);
    visit("opening", self.opening);
  }
};

/// Of the path's tangent in use, one for every unknown multiplier of the saddle point taken off.
NegativeEigenvalues negative_eigenvalues(System& system);

/// The direction with the points flagged in the system's history as loading: that of the step that led here.
/// An empty direction when the tangent is singular.
Tangent arriving_tangent(System& system, const State& state, const std::optional<Heading>& heading = {});

/// The direction in which the path goes on: points that would unload or stick are taken off the set, and
/// unflagged in the history, until all that are left load and slide; what was taken off and would go on after
/// all is put back. One along which the load falls off a structure that is stable under it is taken only
/// where there is no other. Starts from the arriving tangent of the same state.
Tangent leaving_tangent(System& system, const State& state, Tangent arriving,
                        const std::optional<Heading>& heading = {});

/// A point a hair beyond a change of contact, and across which corner its opening got there.
struct BeyondChange {
  std::size_t point = 0;
  Vec2 across = Vec2::Zero();  ///< normal to it, towards where the point is now
  Tangent arriving = {};       ///< of the equilibrium there
};

/// The direction in which the path goes on from there when it seems to lead straight back: with the joint as it is now
/// others unload or stick. Where cracks grow along it, `across` · q̇ ≥ 0; where none does it is as `heading` says. Sets the
/// history's flags; nothing, and nothing changed, where there is no such direction.
std::optional<Tangent> tangent_beyond(System& system, const State& state,
                                      const std::optional<Heading>& heading, const BeyondChange& change);

/// The direction in which a stage begins, its load growing: what the stages before have cracked goes on only
/// where that load drives it, and nothing is followed backwards because it spends energy.
Tangent starting_tangent(System& system, const State& state);

}  // namespace dda
