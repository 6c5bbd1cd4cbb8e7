#pragma once

#include "continuation/solve/krylov_schur.hpp"
#include "continuation/solve/stepper.hpp"

namespace dda {

/// What Trilinos does for a run, from a module that is loaded when it is first asked for: finding its 20 000
/// symbols takes longer than many a run, and most runs end without them.
struct TrilinosModule {
  /// One LOCA::Stepper step: natural continuation in the path parameter s, closed by the control as a LOCA
  /// constraint with unknown λ. Newton starts from the guess (LOCA's predictor, given by the caller).
  Attempt (*controlled_step)(System& system, const StepGoal& goal, const StepperParameters& parameters);
  /// See arc_length_step.
  Attempt (*arc_length_step)(System& system, const State& start, const ArcLength& arc,
                             const StepperParameters& parameters);
  /// See krylov_schur.
  Eigenmodes (*krylov_schur)(const EigenProblem& problem, const Search& search);
};

/// Loads it the first time. Throws std::runtime_error with the loader's words.
const TrilinosModule& trilinos();

}  // namespace dda
