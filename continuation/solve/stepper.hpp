#pragma once

#include <string>

#include "continuation/solve/step_goal.hpp"
#include "framework/deck/node.hpp"

namespace dda {

/// When a Newton iteration ends.
struct NewtonParameters {
  double tolerance = 1e-9;  ///< ‖R‖ relative to the force level of the blocks
  int max_iterations = 15;
};

/// Largest |N| of a control, or of LOCA's arc length relative to the step, that counts as none.
inline constexpr double control_tolerance = 1e-8;

/// What one attempt at a step gave.
struct Attempt {
  bool converged = false;
  State state;
  int newton_iterations = 0;
  int reduced_iterations = 0;  ///< before them, on the cracked points alone
  double residual = 0;         ///< relative to the force level
  int multiplier_iterations = 0;
  double gap = 0;      ///< left by iterated multipliers, see System::relative_gap
  std::string reason;  ///< why it failed
};

/// When the multipliers of augmented Lagrangian joints are good, and where a step starts with them.
struct MultiplierParameters {
  double tolerance = 1e-8;  ///< relative gap, see System::relative_gap
  int max_iterations = 1000;
  bool predicted = true;  ///< start from the path's tangent; otherwise from the last step
};

/// What every attempt needs beside the system: Newton's tolerances and the deck's `nox` and `loca` sublists.
struct StepperParameters {
  NewtonParameters newton;
  MultiplierParameters multipliers;
  bool stability = true;  ///< count the negative eigenvalues of every equilibrium that is tried
  Node nox, loca;
};

/// How an arc length is measured and which way it goes.
struct ArcLength {
  Metric metric = Metric::openings;
  double load_weight = 1;  ///< θ, length of a unit load factor in the metric
  double length = 0;       ///< signed: the sign is that of the load factor's first change
  double goal = 0.5;       ///< θ λ'/‖(d', λ')‖ at the start, so that LOCA keeps θ
};

/// How much is tried before a step is given up: where a shorter one may do, no large dense problem.
enum class Thoroughness { usual, full };

/// One step from an equilibrium to where the control holds: on the cracked
/// points alone where that is all there is to solve, else by LOCA (TrilinosModule::controlled_step).
Attempt controlled_step(System& system, const StepGoal& goal, const StepperParameters& parameters,
                        Thoroughness thoroughness = Thoroughness::usual);

/// One LOCA::Stepper step by LOCA's arc length in λ with the tangent predictor.
Attempt arc_length_step(System& system, const State& start, const ArcLength& arc,
                        const StepperParameters& parameters);

}  // namespace dda
