#include "continuation/detour/increment/load_increment.hpp"

#include "continuation/state/history_guard.hpp"
#include "continuation/state/reach.hpp"

namespace dda {
namespace {

/// The history with every point released that is beyond its strength; nothing when none is.
std::optional<std::vector<History>> overloaded_released(System& system, const State& at) {
  std::vector<History> history = system.history();
  const auto laws = system.laws_at(at);
  bool any = false;
  for (std::size_t p = 0; p < history.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const LawAt law{*point.law, history[p], point.stiffness};
    if (!point.law->releases_at_once() || point.law->is_broken(history[p], point.stiffness)) continue;
    if (law.opening(laws->opening[p]) <= law.kappa()) continue;
    history[p] = point.law->release(laws->opening[p], history[p], point.stiffness, 0);
    any = true;
  }
  return any ? std::optional(std::move(history)) : std::nullopt;
}

}  // namespace

Increment load_increment(Stepper& stepper, const State& start, const LoadStep& step) {
  System& system = stepper.system();
  const HistoryGuard back(system, start.multipliers);
  Increment out;
  int iterations = 0;
  State at = start;
  for (bool more = true; more;) {
    Found found = step.solver.solve(stepper, at, start.load_factor + step.increment);
    iterations += found.newton_iterations;
    out.relaxation_iterations += found.relaxation_iterations;
    out.why = std::move(found.why);
    out.settled.reset();
    if (!found.state) break;
    at = *std::move(found.state);
    out.settled = Settled{at, system.next_history(at), iterations};
    auto released = overloaded_released(system, at);
    more = released.has_value();
    if (more) system.set_history(*std::move(released));
  }
  return out;
}

}  // namespace dda
