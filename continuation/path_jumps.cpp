// Steps that no control leads along: sequentially linear rescue, instantaneous release, load increments.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "continuation/increment/load_increment.hpp"
#include "continuation/path.hpp"
#include "continuation/release.hpp"
#include "continuation/rescue.hpp"

namespace dda {
namespace {

/// |R·Δd|, R of a state with its history: by so much its energies may be off those of the equilibrium which
/// it is within the tolerance.
double residual_work(System& system, const Candidate& at, const std::vector<double>& along) {
  const std::vector<History> history = system.history();
  const std::vector<Vec2> multipliers = system.multipliers();
  system.set_history(at.history);
  system.set_multipliers(at.state.multipliers);
  std::vector<double> r(along.size());
  system.residual(at.state.d, at.state.load_factor, *system.laws_at(at.state.d, at.state.load_factor), r);
  system.set_history(history);
  system.set_multipliers(multipliers);
  return std::abs(std::inner_product(r.begin(), r.end(), along.begin(), 0.0));
}

}  // namespace

std::optional<Point> Path::sequential_step(const std::string& control, double quantum) {
  const auto found = sequentially_linear(walker_.system(), walker_.state(), quantum);
  if (!found || is_mechanism(found->state)) return {};
  const double dissipated = walker_.here().dissipated;
  auto point = jump_to(*found, control);
  if (point && control != "event") {
    ++walker_.effort().rescues;
    report("rescued", fmt::format("sequentially linear steps dissipated {:.3e}",
                                  walker_.here().dissipated - dissipated));
  }
  return point;
}

/// Whether less was put in than is stored and spent, by more than the chord of a curved path and what
/// tolerances leave explain.
bool Path::creates_energy(const Candidate& beyond) const {
  const Candidate& here = walker_.here();
  const double spent = beyond.dissipated - here.dissipated, work = beyond.work - here.work;
  constexpr double of_spent = 0.9, round_off = 1e-8;
  const double created = (beyond.stored - here.stored) + spent - work;
  const double explained = of_spent * spent + round_off * std::abs(beyond.work);
  if (created <= explained) return false;
  std::vector<double> along = beyond.state.d;
  for (std::size_t i = 0; i < along.size(); ++i) along[i] -= here.state.d[i];
  System& system = walker_.system();
  return created > explained + residual_work(system, beyond, along) + residual_work(system, here, along);
}

/// Accepts an equilibrium that no control led to; a wanted value can be passed but not landed on.
std::optional<Point> Path::jump_to(const Settled& found, const std::string& control) {
  Candidate beyond = walker_.settled(found);
  if (!(beyond.residual <= parameters_.newton.tolerance)) {
    report("rejected", fmt::format("{}: relative residual {:.1e}", control, beyond.residual));
    return {};
  }
  if (creates_energy(beyond)) {
    report("rejected", control + ": the jump would create energy");
    return {};
  }
  const auto crossing = first_crossing(beyond);
  const double released = walker_.jump(std::move(beyond));
  memory_.jump_energy += released;
  memory_.step = 0;
  Candidate here = walker_.here();
  --walker_.effort().accepted;
  Point point = keep(std::move(here), control);
  point.jump_energy = released;
  if (crossing) end_at(crossing->landing);
  return point;
}

/// Whether a release has turned the load round while contacts changed: an equilibrium that it does not lead
/// to. A straight piece may do so.
bool Path::turns_load_round(const ReleasedPiece& piece) const {
  constexpr double hardly = -0.1;  // what is held by friction after unloading
  const double before = walker_.state().load_factor;
  return !piece.is_straight && before != 0 && piece.end.state.load_factor / before < hardly;
}

/// Next vertex of an instantaneous release.
std::optional<Point> Path::release_step() {
  const auto held = driver_->held_in_release();
  const auto found = release_piece(walker_.system(), walker_.state(), parameters_, held ? &*held : nullptr);
  if (found && !is_mechanism(found->end.state) && !turns_load_round(*found))
    if (auto point = jump_to(found->end, "release")) return point;
  if (driver_->may_be_rescued())
    if (auto point = release_at_lower_load()) return point;
  return end(Ending::Kind::stopped_early,
             held ? "failure: what is released leaves no equilibrium under this control; use `staged`"
                  : "what is released leaves no equilibrium");
}

/// The largest of some shares of the load at which an equilibrium is left after everything pending has been
/// released: what a test would find after a jump, booked as one.
std::optional<Point> Path::release_at_lower_load() {
  const double load_factor = walker_.state().load_factor;
  for (const double share : {1.0, 0.9, 0.75, 0.5, 0.25, 0.1, 0.0}) {
    const auto found = release_at_load(walker_.system(), walker_.state(), parameters_, share * load_factor);
    if (!found || is_mechanism(found->state)) continue;
    auto point = jump_to(*found, "release");
    if (!point) continue;
    ++walker_.effort().rescues;
    report("rescued", fmt::format("the release jumped to {:g} of the load factor", share));
    return point;
  }
  return {};
}

/// The load raised by the largest of halved increments that still finds an equilibrium.
std::optional<Point> Path::increment_step() {
  if (memory_.step == 0) memory_.step = driver_->load_increment() * next_event(walker_);
  if (!std::isfinite(memory_.step)) return linear_step();
  constexpr double smallest_share = 1e-4;
  const double first = memory_.step;
  const double smallest = smallest_share * std::max(first, std::abs(walker_.state().load_factor));
  std::string why;
  for (double increment = first; increment > smallest; increment *= 0.5) {
    const Increment found =
        load_increment(walker_.system(), walker_.state(), {increment, *driver_->load_solver()}, parameters_);
    walker_.effort().newton_iterations += found.newton_iterations;
    walker_.effort().relaxation_iterations += found.relaxation_iterations;
    if (!found.settled || is_mechanism(found.settled->state)) {
      why = found.settled ? "what is left is a mechanism" : found.why;
      ++walker_.effort().rejected;
      report("rejected", fmt::format("load_increments: {}", why));
      continue;
    }
    auto point = jump_to(*found.settled, "load_increments");
    if (!point) {
      why = "what was found is not the next point of this path";
      continue;
    }
    point->newton_iterations = found.newton_iterations;
    memory_.step = increment;
    return point;
  }
  return end(Ending::Kind::stopped_early,
             fmt::format("failure: no equilibrium beyond a load factor of {:g}: {}",
                         walker_.state().load_factor, why));
}

}  // namespace dda
