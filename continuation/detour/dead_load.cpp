#include "continuation/detour/dead_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/detour/release.hpp"
#include "continuation/state/acceptance.hpp"
#include "continuation/state/standstill.hpp"

namespace dda {
namespace {

/// Whether a load factor lies on the way, or where the strength was passed that is borne beyond by next to nothing (Excess).
bool lies_on_way(double load_factor, const Candidate& here, const Candidate& beyond) {
  constexpr double round_off = 1e-9;
  const double from = here.state.load_factor, to = beyond.state.load_factor;
  const double margin = round_off * std::abs(to), behind = here.excess.value > 0 ? to - from : margin;
  return load_factor >= from - behind && load_factor <= to + margin;
}

/// Goes to where the first point on the way to `beyond`, which is beyond the strength of some, stands at its own. Returns "" or why
/// it cannot.
std::string land_on_strength(Walker& walker, const Candidate& beyond) {
  const auto equation = make_event_equation(walker.system(), Initiation::awaited);
  const Attempt tried = walker.attempt(*equation, 1, beyond.state);
  if (!tried.converged) return tried.reason;
  if (!lies_on_way(tried.state.load_factor, walker.here(), beyond))
    return "the load at which the first point reaches its strength was not found";
  Candidate candidate = walker.evaluate(tried);
  if (std::string why = objection_to(candidate.excess, walker.system()); !why.empty()) return why;
  walker.accept(std::move(candidate));
  return is_release_pending(walker.system()) ? "" : objection_to(beyond.excess, walker.system());
}

/// Why only weak springs would hold a state; "" where the structure does.
std::string objection_to_holding(const State& at, const System& system) {
  const Holding holding = holding_of(system, at);
  return objection_to(holding, {system.equilibrium().extent(), holding.load}, system.equilibrium());
}

/// Why what a release has led to is no equilibrium that holds; "" when it is one.
std::string objection_to(const Candidate& found, const Walker& walker) {
  if (!(found.residual <= walker.parameters().newton.tolerance))
    return fmt::format("the relative residual is {:.1e}", found.residual);
  return objection_to_holding(found.state, walker.system());
}

/// Takes the strength of what stands at it, and of all that this overloads, while the load stays. Returns ""
/// or why nothing carries the load then.
std::string release(Walker& walker) {
  System& system = walker.system();
  const State& at = walker.state();
  const auto found = release_at_load(walker.stepper(), at, at.load_factor);
  std::string why = "there is no equilibrium without it";
  if (found) {
    Candidate next = walker.settled(*found);
    why = objection_to(next, walker);
    if (why.empty() && !walker.confirm(next)) why = "NOX does not converge there";
    if (why.empty()) walker.jump(std::move(next));
  }
  if (why.empty()) return {};
  return fmt::format("strength is lost at a load factor of {:.4g} at {}: {}", at.load_factor,
                     places_of(system, active_points(system, at)), why);
}

}  // namespace

std::string apply_full_stage(Walker& walker) {
  constexpr double smallest = 1e-4, cut = 0.25;
  const auto control = make_gauge_equation({.rows = {}, .per_load_factor = 1});
  double step = 1;
  while (walker.state().load_factor < 1) {
    if (walker.leaving().d.empty()) return "the tangent stiffness is singular";
    const double rest = 1 - walker.state().load_factor;
    const double wanted = std::min(step, rest);
    const Attempt tried =
        walker.attempt(*control, wanted, walker.ahead(wanted / walker.leaving().load_factor));
    std::string refused = tried.converged ? objection_to_holding(tried.state, walker.system()) : tried.reason;
    if (refused.empty()) {
      Candidate candidate = walker.evaluate(tried);
      if (objection_to(candidate.excess, walker.system()).empty()) {
        if (wanted == rest) candidate.state.load_factor = 1;
        walker.accept(std::move(candidate));
        continue;
      }
      refused = land_on_strength(walker, candidate);
      if (refused.empty()) {
        if (std::string why = release(walker); !why.empty()) return why;
        continue;
      }
    }
    step = cut * wanted;
    if (step < smallest) return refused;
  }
  return {};
}

}  // namespace dda
