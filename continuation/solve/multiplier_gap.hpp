#pragma once

#include "continuation/solve/settling.hpp"
#include "continuation/solve/stepper.hpp"

namespace dda {

/// The one rule by which iterated multipliers are closed: after each solution the forces of the springs are
/// carried over into them, until no gap is left or none will be.
class MultiplierGap {
 public:
  MultiplierGap(System& system, const MultiplierParameters& parameters)
      : system_(system), parameters_(parameters), settling_(parameters) {}

  /// Notes the gap that a converged solution leaves. True when the multipliers have been carried over and the
  /// equations are to be solved again; false at the end, the solution not being converged where a gap stays.
  bool is_carried_over(Attempt& solution);

 private:
  System& system_;
  const MultiplierParameters& parameters_;
  Settling settling_;
};

}  // namespace dda
