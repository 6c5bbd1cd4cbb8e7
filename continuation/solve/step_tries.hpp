#pragma once

#include <string>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// Tries the ways to the end of one step, whose control has been started: the cracked points alone, contact
/// and friction solved exactly, all unknowns. What the first finds is only where the others begin. Where they are all
/// there is to solve, cracks open and a shorter step can be tried, it is all that is tried: Newton's method would go
/// the same way on all unknowns, at their price.
class StepTries {
 public:
  StepTries(Stepper& stepper, const StepGoal& goal, Thoroughness thoroughness);
  Attempt find();

 private:
  bool are_few() const;
  bool a_shorter_step_helps() const;
  bool only_touches() const { return touches_ && num_cracked_ == 0 && are_few(); }
  void by_contacts();
  void by_all(const State& guess);

  Stepper& stepper_;
  System& system_;
  const StepGoal& goal_;
  Thoroughness thoroughness_;
  bool touches_ = false;
  std::size_t num_cracked_ = 0;
  Attempt out_;
  std::string of_contacts_;
};

}  // namespace dda
