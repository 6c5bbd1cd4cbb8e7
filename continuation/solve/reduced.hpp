#pragma once

#include <optional>

#include "continuation/contact/cracked_points.hpp"
#include "continuation/equation/control_equation.hpp"

namespace dda {

/// What was found on the cracked points alone.
struct Reduced {
  State state;
  int iterations = 0;
};

/// Newton's method on the cracked points alone (contact/cracked_points.hpp). The state that is found is
/// looked at in full: points that crack there are taken in and the iteration starts again from the guess, so
/// that it goes the way of Newton's method for all unknowns. It is a better guess and no more: equilibrium is
/// judged by the full residual. Nothing where no base is kept, under controls that look at every point, with
/// initial stress or iterated multipliers, and where the iteration does not converge.
std::optional<Reduced> solve_reduced(System& system, const ControlEquation& control, double s,
                                     const State& guess, int max_iterations);

/// Chooses the base for solving contacts near a state, by that state alone: the intact structure, with the
/// damage of the history where so much has cracked that columns for all of it would cost more. Contact of
/// separate bodies is closed and held in it.
void prepare_contacts(System& system, const State& guess);

/// How contacts are solved: by Newton's method where it does it, or by walking at once, as where Newton's
/// method has ended far away on a singular matrix.
struct ContactSettings {
  int max_iterations = 15;
  /// The equilibrium from which walks begin: between it and the wanted one they are equilibria of the path.
  const State* from = nullptr;
  std::size_t most_points = 1500;  ///< more are not tried: dense equations grow with the third power
  double tolerance = 1e-9;         ///< of the equations of the whole structure, relative
  bool tries_newton = true;
};

/// Contact and friction solved exactly on the points that are not held as in the intact structure, with
/// Newton's method for what cracks around it, also under frozen damage, iterated multipliers and controls
/// that look at every point; after `prepare_contacts`. Nothing with initial stress, where no joint is in
/// contact, where more than `most_points` points would take part, and where there is no equilibrium. `points`
/// are kept from call to call of one step, as while multipliers are iterated.
std::optional<Reduced> solve_contacts(System& system, const ControlEquation& control, double s,
                                      const State& guess, const ContactSettings& settings,
                                      std::optional<CrackedPoints>& points);
/// Points that are not held at a state as in the intact structure.
std::size_t num_changed(System& system, const State& at);
/// Those among them that were bonded.
std::size_t num_cracked(System& system, const State& at);

}  // namespace dda
