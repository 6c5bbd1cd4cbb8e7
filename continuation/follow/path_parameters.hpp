#pragma once

#include <map>
#include <string>
#include <vector>

#include "continuation/control/control.hpp"
#include "continuation/linear/linear_system.hpp"

namespace dda {

/// Step sizes as multiples of what the path itself suggests, and how closely it is followed.
struct StepSizes {
  double accuracy = 0.02;
  double largest = 1;
};

/// Where the path is to end.
struct StopRules {
  double load_below = 0;
  std::map<std::string, double> gauges;
  int after_steps = 0;  ///< a goal; 0: none
  int steps = 1000;     ///< a limit
  double energy_error = 0.05;
};

/// What the path does where it may branch.
enum class Branching {
  follow,    ///< goes on as it came
  to_lowest  ///< takes the branch on which the load falls fastest
};

/// The deck's `path` section.
struct PathParameters : StepperParameters {
  ControlChoice control;
  StepSizes step;
  StopRules stop;
  Branching branch = Branching::follow;
  std::string load_gauge;
  double peak_tolerance = 1e-4;
  DirectSolverChoice linear;
  LinearSystem::Update update = LinearSystem::Update::low_rank;
  std::vector<std::string> expected_to_stop;
  Position where;
};

Schema<PathParameters> path_schema();

}  // namespace dda
