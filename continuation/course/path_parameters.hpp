#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continuation/control/control.hpp"
#include "continuation/linear/linear_system.hpp"

namespace dda {

/// By what the next step is sized.
enum class Sizing {
  deviation,   ///< how well the tangent has predicted the last one
  iterations,  ///< how many of Newton's iterations it took
  constant
};

/// Where Newton's method begins.
enum class Predictor {
  tangent,   ///< as far along the leaving tangent as the step goes
  secant,    ///< as far beyond the last two points; on the tangent where these do not tell
  constant,  ///< at the last point
};

/// Step sizes as multiples of what the path itself suggests, and in units of what the control prescribes.
struct StepSizes {
  double accuracy = 0.02;
  double largest = 0.1;
  std::optional<double> first, shortest, longest;  ///< in the control's own unit
  Sizing sizing = Sizing::deviation;
  std::optional<double> aggressiveness;  ///< of `iterations`
  double cut = 0.25;                     ///< share that is left of a step that has failed
  Predictor predictor = Predictor::tangent;
};

/// Where the path is to end.
struct StopRules {
  double load_below = 0;
  std::map<std::string, double> gauges;
  int after_steps = 0;       ///< a goal; 0: none
  std::optional<int> steps;  ///< a limit; without one, PathState::most_steps
  std::optional<double> load_factor_above, load_factor_below;
  double energy_error = 0.05;
};

/// What the path does where it may branch.
enum class Branching {
  follow,    ///< goes on as it came
  to_lowest  ///< takes the branch on which the load falls fastest
};

/// What comes after the path.
enum class AfterPath {
  end,    ///< nothing
  motion  ///< what is left is let go
};

/// The deck's `path` section.
struct PathParameters : StepperParameters {
  ControlChoice control;
  StepSizes step;
  StopRules stop;
  Branching branch = Branching::follow;
  std::optional<AfterPath> then;  ///< none: `motion` where the deck has such a section
  std::string load_gauge;
  double peak_tolerance = 1e-4;
  DirectSolverChoice linear;
  LinearSystem::Update update = LinearSystem::Update::low_rank;
  std::vector<std::string> expected_to_stop;
  std::string lists;  ///< parameter lists, which stand for keys of the deck when it has been read
  Node nox, loca;     ///< likewise
  Position where;
};

Schema<PathParameters> path_schema();

/// Keys of the section, by name, that are set to something else than their default and that a control does not heed:
/// one whose steps have no size finds no branches and brackets no peak; load increments are halved and not judged.
std::vector<std::string> unheeded_keys(const PathParameters& path, const Control& control);

}  // namespace dda
