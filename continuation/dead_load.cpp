#include "continuation/dead_load.hpp"

#include <algorithm>

namespace dda {

std::string apply_full_stage(Walker& walker) {
  const auto control = make_gauge_control({.rows = {}, .per_load_factor = 1});
  constexpr double smallest = 1e-4;
  double step = 1;
  while (walker.state().load_factor < 1) {
    if (walker.leaving().d.empty()) return "the tangent stiffness is singular";
    const double rest = 1 - walker.state().load_factor;
    const double wanted = std::min(step, rest);
    const Attempt tried =
        walker.attempt(*control, wanted, walker.ahead(wanted / walker.leaving().load_factor));
    if (!tried.converged) {
      step = 0.25 * wanted;
      if (step < smallest) return tried.reason;
      continue;
    }
    Candidate candidate = walker.evaluate(tried);
    if (wanted == rest) candidate.state.load_factor = 1;
    walker.accept(std::move(candidate));
  }
  return {};
}

}  // namespace dda
