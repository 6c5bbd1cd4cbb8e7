#include "continuation/solve/multiplier_gap.hpp"

#include <fmt/format.h>

namespace dda {

bool MultiplierGap::is_carried_over(Attempt& solution) {
  if (!system_.iterates_multipliers()) return false;
  const auto laws = system_.laws_at(solution.state);
  solution.gap = system_.relative_gap(*laws);
  if (solution.gap <= parameters_.tolerance) return false;
  if (solution.multiplier_iterations >= parameters_.max_iterations ||
      settling_.is_out_of_reach(solution.gap, system_.active_set(*laws))) {
    solution.reason = fmt::format("the multipliers did not settle in {} iterations (relative gap {:.1e})",
                                  solution.multiplier_iterations, solution.gap);
    solution.converged = false;
    return false;
  }
  ++solution.multiplier_iterations;
  system_.set_multipliers(system_.next_multipliers(*laws));
  return true;
}

}  // namespace dda
