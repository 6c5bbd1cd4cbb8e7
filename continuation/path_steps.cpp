// Steps of a path: which control, how it is tried, what follows when it fails.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/path.hpp"
#include "continuation/release.hpp"
#include "continuation/rescue.hpp"

namespace dda {
namespace {

/// A step is tried again with this share of its size when Newton fails.
constexpr double cut = 0.25;
/// Below this share of its first size a step is given up.
constexpr double smallest_share = 1e-4;
/// How many times one step is shortened for the peak or a landing.
constexpr int most_refinements = 20;

}  // namespace

std::optional<Point> Path::take_step() {
  if (leg().unloads) return unload_step();
  if (is_release_pending(walker_.system()) && driver_->load_increment() == 0) return release_step();
  if (walker_.leaving().d.empty())
    return end(Ending::Kind::stopped_early, "the tangent stiffness is singular here");
  const bool cracked = walker_.here().dissipated > 0 || walker_.leaving().dissipates;
  if (driver_->load_increment() > 0) return increment_step();
  if (!cracked) return event_step();
  if (const std::string why = driver_->obstacle(walker_.leaving()); !why.empty())
    return end(Ending::Kind::stopped_early, why);
  const Move move = driver_->next(walker_);
  const bool between_releases = releases_at_once_ && !walker_.leaving().dissipates;
  if (!move.to_event && !between_releases) return controlled_step(move);
  if (!walker_.leaving().dissipates) return event_step();
  auto point = sequential_step("event", std::numeric_limits<double>::min());
  return point ? point : end(Ending::Kind::stopped_early, "no interface limits the load any more");
}

std::optional<Point> Path::event_step() {
  const double amount = next_event(walker_);
  if (!std::isfinite(amount)) return linear_step();
  driver_->obstacle(walker_.leaving());  // fixes the direction of a prescribed gauge on the elastic branch
  if (auto point = land_ahead(amount)) return point;
  const Move move = event_move(walker_);
  std::string why;
  const auto candidate = try_step(move, amount, why);
  if (!candidate) {
    if (driver_->may_be_rescued())
      if (auto point = sequential_step("sequentially_linear", memory_.last_quantum)) return point;
    return end(Ending::Kind::stopped_early, "the next initiation was not found: " + why);
  }
  if (const auto crossing = first_crossing(*candidate))
    if (auto point = land(*candidate, *crossing, "event")) return point;
  memory_.step = 0;
  return keep(*candidate, move.control);
}

/// Lands on a wanted value that lies before an event predicted `amount` ahead.
std::optional<Point> Path::land_ahead(double amount) {
  Candidate predicted = walker_.here();
  predicted.state = walker_.ahead(amount);
  const auto crossing = first_crossing(predicted);
  return crossing ? land(predicted, *crossing, "event") : std::nullopt;
}

/// Nothing can crack any more: the response is linear up to the full reference load.
std::optional<Point> Path::linear_step() {
  const double rest = 1 - walker_.state().load_factor;
  if (rest <= 0 && walker_.here().dissipated > 0)
    return end(Ending::Kind::stopped_early, "no interface can crack any further under this load");
  if (rest <= 0)
    return end(Ending::Kind::goal_reached, "nothing can crack; the full reference load is applied");
  const Move move{.control = "load",
                  .equation = make_gauge_control({.rows = {}, .per_load_factor = 1}),
                  .arc = {},
                  .rate = walker_.leaving().load_factor};
  std::string why;
  const auto candidate = try_step(move, rest / walker_.leaving().load_factor, why);
  if (!candidate) return end(Ending::Kind::stopped_early, why);
  if (const auto crossing = first_crossing(*candidate))
    if (auto point = land(*candidate, *crossing, move.control)) return point;
  return keep(*candidate, move.control);
}

std::optional<Point> Path::controlled_step(const Move& move) {
  const bool known = memory_.step > 0 && memory_.step_control == move.control;
  double amount = bounded(known ? memory_.step : first_amount());
  if (load_of(walker_.ahead(amount)) <= 0 && load_of(walker_.state()) > 0)
    if (auto point = rupture()) return point;
  const double smallest = smallest_share * amount;
  std::string why;
  for (int refinements = 0; amount > smallest;) {
    const auto candidate = try_step(move, amount, why);
    if (!candidate) {
      if (load_of(walker_.ahead(amount / cut)) <= 0)
        if (auto point = rupture()) return point;
      amount *= cut;
      continue;
    }
    if (const auto share = before_peak(*candidate); share && refinements++ < most_refinements) {
      report("refined", "the step crosses the limit point");
      ++walker_.effort().rejected;
      amount *= *share;
      continue;
    }
    if (is_coarse(*candidate) && refinements++ < most_refinements) {
      report("refined", "the step leaves too much energy unaccounted for");
      ++walker_.effort().rejected;
      amount *= 0.5;
      continue;
    }
    const double strength = releases_at_once_ ? share_to_strength(*candidate) : 1;
    if (const auto crossing = first_crossing(*candidate); crossing && crossing->share <= strength) {
      if (auto point = land(*candidate, *crossing, move.control)) return point;
      amount *= 0.5 * std::max(crossing->share, 0.1);
      continue;
    }
    if (strength < 1) {
      if (auto point = land_on_strength(*candidate, move.control)) return point;
      amount *= 0.5 * std::max(strength, 0.1);
      continue;
    }
    resize(*candidate, amount, move);
    return keep(*candidate, move.control);
  }
  if (auto point = rupture()) return point;
  if (driver_->may_be_rescued())
    if (auto point = sequential_step("sequentially_linear", memory_.last_quantum)) return point;
  if (const std::string turned = turning_point(); !turned.empty())
    return end(Ending::Kind::stopped_early, turned);
  constexpr double hardly_any = 1e-3;
  if (const double left = load_of(walker_.state()) / memory_.peak_load; left < hardly_any)
    return end(Ending::Kind::goal_reached,
               fmt::format("complete rupture: what is left is a mechanism ({:.1e} of the peak)", left));
  return end(Ending::Kind::stopped_early,
             fmt::format("{} control found no next equilibrium: {}", move.control, why));
}

std::optional<Candidate> Path::try_step(const Move& move, double amount, std::string& why) {
  const Attempt tried = attempt(move, amount);
  if (!tried.converged) {
    why = tried.reason;
    report("rejected", fmt::format("{}: {}", move.control, why));
    return {};
  }
  Candidate candidate = walker_.evaluate(tried);
  why = objection(candidate);
  if (why.empty()) return candidate;
  ++walker_.effort().rejected;
  report("rejected", fmt::format("{}: {}", move.control, why));
  return {};
}

Attempt Path::attempt(const Move& move, double amount) {
  if (!move.arc) {
    const double step = move.to_event ? 1.0 : amount * move.rate;
    return walker_.attempt(*move.equation, step, walker_.ahead(amount));
  }
  ArcLength arc = *move.arc;
  arc.length *= amount * move.rate;
  return walker_.attempt(arc);
}

/// Work of the step that neither storage nor dissipation explains: quadrature error, or a jump [FL].
double Path::unaccounted(const Candidate& candidate) const {
  const Candidate& here = walker_.here();
  return std::abs((candidate.work - here.work) - (candidate.stored - here.stored) -
                  (candidate.dissipated - here.dissipated));
}

/// Whether the quadrature of the work misses a kink within the step: the energy balance of a run is the sum
/// of these.
bool Path::is_coarse(const Candidate& candidate) const {
  constexpr double share = 0.01;  // of the accuracy, twice what the step size aims at
  return unaccounted(candidate) > share * parameters_.step.accuracy * std::abs(candidate.work);
}

/// Why a converged state is not the next point of this path; "" when it is.
std::string Path::objection(const Candidate& candidate) const {
  const Candidate& here = walker_.here();
  const double dissipated = candidate.dissipated - here.dissipated, work = candidate.work - here.work;
  const double missing = unaccounted(candidate);
  constexpr double of_dissipation = 0.1, of_total = 0.02, of_work = 0.01;
  if (missing >
      of_dissipation * std::max(dissipated, of_total * candidate.dissipated) + of_work * std::abs(work))
    return fmt::format("the step jumps: {:.1e} of its work is unaccounted for", missing / std::abs(work));
  const double before = load_of(walker_.state()), after = load_of(candidate.state);
  if (here.dissipated > 0 && dissipated <= 0 && after < before && walker_.leaving().dissipates)
    return "the step retraces the unloading branch";
  return {};
}

/// Looks beyond the point where a control ends, by dissipation: the driver's own word if the path turns
/// against it.
std::string Path::turning_point() {
  if (!walker_.leaving().dissipates) return {};
  const double smallest = std::max(memory_.last_quantum, 1e-4 * walker_.here().dissipated);
  for (const double multiple : {1.0, 10.0, 100.0}) {
    std::string why;
    const auto beyond = try_step(dissipation_move(walker_), multiple * smallest, why);
    if (!beyond) continue;
    if (std::string turned = driver_->obstacle(beyond->arriving); !turned.empty()) return turned;
  }
  return {};
}

/// Whether only the weak springs hold the structure any more: it moves far beyond what it did under its peak.
bool Path::is_mechanism(const State& state) const {
  constexpr double far = 100;
  return std::abs(displacement_of(state)) > far * memory_.largest_displacement;
}

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

/// Whether less was put in than is stored and spent, by more than the chord of a curved path explains.
bool Path::creates_energy(const Candidate& beyond) const {
  const Candidate& here = walker_.here();
  const double spent = beyond.dissipated - here.dissipated, work = beyond.work - here.work;
  constexpr double of_spent = 0.5, round_off = 1e-8;
  return work - (beyond.stored - here.stored) - spent < -of_spent * spent - round_off * std::abs(beyond.work);
}

/// Accepts an equilibrium that no control led to; a wanted value can be passed but not landed on.
std::optional<Point> Path::jump_to(const Settled& found, const std::string& control) {
  Candidate beyond = walker_.settled(found);
  if (!(beyond.residual <= beyond.tolerance)) {
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

/// Next vertex of an instantaneous release.
std::optional<Point> Path::release_step() {
  const auto held = driver_->held_in_release();
  const auto found =
      release_piece(walker_.system(), walker_.state(), parameters_.newton, held ? &*held : nullptr);
  if (found && !is_mechanism(found->state))
    if (auto point = jump_to(*found, "release")) return point;
  return end(Ending::Kind::stopped_early,
             held ? "failure: what is released leaves no equilibrium under this control; use `staged`"
                  : "what is released leaves no equilibrium");
}

/// The load raised by the largest of halved increments that still finds an equilibrium.
std::optional<Point> Path::increment_step() {
  if (memory_.step == 0) memory_.step = driver_->load_increment() * next_event(walker_);
  if (!std::isfinite(memory_.step)) return linear_step();
  const double first = memory_.step;
  for (double increment = first; increment > smallest_share * first; increment *= 0.5) {
    const auto found = load_increment(walker_.system(), walker_.state(), parameters_.newton, increment);
    if (!found || is_mechanism(found->state)) {
      ++walker_.effort().rejected;
      continue;
    }
    auto point = jump_to(*found, "load_increments");
    if (!point) continue;
    memory_.step = increment;
    return point;
  }
  return end(Ending::Kind::stopped_early, fmt::format("failure: no equilibrium beyond a load factor of {:g}",
                                                      walker_.state().load_factor));
}

/// A tenth of the way to the leg's goal, off the damage surfaces.
std::optional<Point> Path::unload_step() {
  const Landing goal = leg().until.front();
  const double rest = goal.value - walker_.value(goal.gauge);
  if (walker_.leaving().d.empty())
    return end(Ending::Kind::stopped_early, "the tangent stiffness is singular here");
  if (walker_.leaving().rate(goal.gauge) * rest < 0 && !walker_.leaving().dissipates) walker_.turn_back();
  const double rate = walker_.leaving().rate(goal.gauge);
  if (!(rate * rest > 0))
    return end(Ending::Kind::stopped_early,
               fmt::format("unloading does not lead to {} = {:g}", goal.name, goal.value));
  constexpr double parts = 10;
  if (memory_.step == 0) memory_.step = std::abs(rest) / parts;
  const Move move{
      .control = "unloading", .equation = make_gauge_control(goal.gauge), .arc = {}, .rate = rate};
  std::string why;
  for (double length = memory_.step; length > smallest_share * memory_.step; length *= cut) {
    const bool arrives = length > (1 - 1e-9) * std::abs(rest);
    const double amount = arrives ? rest / rate : length / std::abs(rate);
    const auto candidate = try_step(move, amount, why);
    if (!candidate) continue;
    Point point = keep(*candidate, move.control);
    if (arrives) {
      point.landed.push_back(fmt::format("{}={:g}", goal.name, goal.value));
      end_at(goal);
    }
    return point;
  }
  return end(Ending::Kind::stopped_early, "unloading found no next equilibrium: " + why);
}

}  // namespace dda
