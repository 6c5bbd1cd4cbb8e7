// Steps of a path: which control, how it is tried, what follows when it fails.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "continuation/detour/release.hpp"
#include "continuation/path/advice.hpp"
#include "continuation/path/path.hpp"

namespace dda {
namespace {

/// A step is tried again with this share of its size when Newton fails.
constexpr double cut = 0.25;
/// Below this share of its first size a step is given up.
constexpr double smallest_share = 1e-4;
/// How many times one step is shortened for the peak or a landing.
constexpr int most_refinements = 20;
/// And for what it may hide between its ends.
constexpr int most_looks = 7;

}  // namespace

std::optional<Point> Path::take_step() {
  if (leg().unloads) return unload_step();
  if (releases_at_once_ && control_->load_increment() == 0 && is_release_pending(walker_.system()))
    return release_step();
  if (walker_.leaving().d.empty())
    return end(
        Ending::Kind::stopped_early,
        fmt::format("the tangent stiffness is singular here: a part is free to move; {}", what_to_try));
  const bool cracked = walker_.here().dissipated > 0 || walker_.leaving().dissipates;
  if (control_->load_increment() > 0) return increment_step();
  if (!cracked) return event_step();
  if (const std::string why = control_->obstacle(walker_.leaving()); !why.empty())
    return end(Ending::Kind::stopped_early, why);
  const Move move = control_->next(walker_);
  const bool between_releases =
      releases_at_once_ && !walker_.leaving().dissipates && std::isfinite(next_event(walker_));
  if (!move.to_event && !between_releases) return controlled_step(move);
  if (!walker_.leaving().dissipates) return event_step();
  auto point = sequential_step("event", std::numeric_limits<double>::min());
  return point ? point : end(Ending::Kind::stopped_early, "no interface limits the load any more");
}

std::optional<Point> Path::event_step() {
  const double amount = amount_to_event();
  if (!std::isfinite(amount)) return can_slide() ? sliding_step() : linear_step();
  control_->obstacle(walker_.leaving());  // fixes the direction of a prescribed gauge on the elastic branch
  if (auto point = land_ahead(amount)) return point;
  const Move move = event_move(walker_);
  std::string why;
  const auto candidate = try_step(move, amount, why);
  if (!candidate) {
    if (control_->may_be_rescued() && walker_.leaving().dissipates)
      if (auto point = sequential_step("sequentially_linear", memory_.last_quantum)) return point;
    if (can_slide()) return sliding_step();
    if (auto point = approach(amount)) return point;
    if (control_->may_be_rescued()) {
      if (auto point = sequential_step("sequentially_linear", memory_.last_quantum)) return point;
      if (auto point = driven_step()) return point;
    }
    return end_without_equilibrium("the next initiation was not found: " + why);
  }
  if (is_coarse(*candidate)) {
    if (auto point = can_slide() ? sliding_step() : approach(amount)) return point;
    ending_ = {};  // no finer way was found: the event itself stands
  }
  if (const auto crossing = first_crossing(*candidate)) {
    if (auto point = land(*candidate, *crossing, "event")) return point;
    if (auto point = approach(crossing->share * amount)) return point;
  }
  memory_.step = 0;
  return keep(*candidate, move.control);
}

/// A part of the way to an event that cannot be reached in one step, or not without losing track of the
/// energy, because contacts change on the way.
std::optional<Point> Path::approach(double amount) {
  const Move move{.control = "load",
                  .equation = make_gauge_equation({.rows = {}, .per_load_factor = 1}),
                  .arc = {},
                  .rate = walker_.leaving().load_factor};
  std::string why;
  constexpr double resolved = 0.02;  // of the way: a kink of friction or contact need not be cut finer
  for (double share = 0.5; share > smallest_share; share *= 0.5) {
    const auto candidate = try_step(move, share * amount, why);
    if (!candidate || is_mechanism(candidate->state) || (share > resolved && is_coarse(*candidate))) continue;
    if (const auto crossing = first_crossing(*candidate))
      if (auto point = land(*candidate, *crossing, move.control)) return point;
    return keep(*candidate, move.control);
  }
  return {};
}

/// Lands on a wanted value that lies before an event predicted `amount` ahead, up to which nothing is
/// dissipated unless joints slide.
std::optional<Point> Path::land_ahead(double amount, bool slides) {
  Candidate predicted = walker_.here();
  predicted.state = walker_.ahead(amount);
  if (slides) predicted.dissipated = std::numeric_limits<double>::infinity();
  const auto crossing = first_crossing(predicted);
  return crossing ? land(predicted, *crossing, "event") : std::nullopt;
}

/// Nothing can crack any more: the response is linear up to the full reference load.
std::optional<Point> Path::linear_step() {
  const double rest = 1 - walker_.state().load_factor;
  constexpr double round_off = 1e-12;
  if (rest <= round_off && walker_.here().dissipated > 0)
    return end(Ending::Kind::stopped_early, "no interface can crack any further under this load");
  if (rest <= round_off)
    return end(Ending::Kind::goal_reached, "nothing can crack; the full reference load is applied");
  const Move move{.control = "load",
                  .equation = make_gauge_equation({.rows = {}, .per_load_factor = 1}),
                  .arc = {},
                  .rate = walker_.leaving().load_factor};
  std::string why;
  const auto candidate = try_step(move, rest / walker_.leaving().load_factor, why);
  if (!candidate || is_coarse(*candidate)) {
    auto point = approach(rest / walker_.leaving().load_factor);
    if (point || !candidate) return point ? point : end(Ending::Kind::stopped_early, why);
  }
  if (const auto crossing = first_crossing(*candidate))
    if (auto point = land(*candidate, *crossing, move.control)) return point;
  return keep(*candidate, move.control);
}

std::optional<Point> Path::controlled_step(const Move& move) {
  const bool known = memory_.step > 0 && memory_.step_control == move.control;
  double amount = bounded(known ? memory_.step / unit_of(move) : first_amount());
  if (load_of(walker_.ahead(amount)) <= 0 && load_of(walker_.state()) > 0)
    if (auto point = rupture()) return point;
  const double smallest = smallest_share * amount, natural = std::max(amount, bounded(first_amount()));
  constexpr double few_cuts = 0.1;  // of the step: more is tried, which takes long, once they have not helped
  std::string why = "the tangent does not tell how far a step may go";
  const auto shorten = [&](const std::string& because, double share) {
    why = because;
    report("refined", why);
    ++walker_.effort().rejected;
    amount *= share;
  };
  const auto strays = [&](const Candidate& candidate) -> std::string {
    constexpr double far = 0.5;  // of all displacement so far, and of what a step may change the load by
    const State ahead = walker_.ahead(amount);
    const double moved = std::abs(displacement_of(candidate.state) - displacement_of(ahead));
    if (memory_.largest_displacement > 0 &&
        moved > far * std::max(memory_.largest_displacement, std::abs(displacement_of(candidate.state))))
      return "the step strays from its tangent by more than half of all displacement so far";
    const double fallen = load_of(ahead) - load_of(candidate.state);
    if (walker_.leaving().dissipates && memory_.peak_load > 0 && load_of(candidate.state) > 0 &&
        fallen > far * parameters_.step.largest * memory_.peak_load)
      return "the step falls off its tangent by more than half of what the load may change in one";
    return {};
  };
  double looked_at = 0;
  Snap snaps{.natural = natural};
  Looks looked;
  for (int refinements = 0, looks = 0; amount > smallest;) {
    const bool is_cut = amount <= few_cuts * natural;
    const auto candidate = try_step(move, amount, why, is_cut ? Thoroughness::full : Thoroughness::usual);
    if (!candidate) {
      if (load_of(walker_.ahead(amount / cut)) <= 0)
        if (auto point = rupture()) return point;
      if (jumped_)
        if (auto point = snap(*jumped_, move, amount, snaps)) return point;
      if (auto point = land_on_turn(amount, is_cut, move)) return point;
      amount *= cut;
      continue;
    }
    if (const std::string far = strays(*candidate); !far.empty()) {
      why = far;
      reject(move.control, why);
      amount *= cut;
      continue;
    }
    if (const auto share = before_peak(*candidate); share && refinements++ < most_refinements) {
      shorten("the step crosses the limit point", *share);
      continue;
    }
    if (const auto share = before_turn(*candidate); share && refinements++ < most_refinements) {
      shorten("the step crosses a turning point of a gauge", *share);
      continue;
    }
    if (const auto share = before_hidden_turn(*candidate, amount); share && looks++ < most_looks) {
      looked.for_peak = looked.for_peak || may_hide_peak(*candidate);
      looked.for_turn = looked.for_turn || may_hide_turns(*candidate);
      looked_at = std::max(looked_at, amount);
      shorten("the step may hide a turn between its ends", *share);
      continue;
    }
    if (is_coarse(*candidate) && refinements++ < most_refinements) {
      if (auto point = snap(*candidate, move, amount, snaps)) return point;
      shorten("the step leaves too much energy unaccounted for", 0.5);
      continue;
    }
    if (auto unstable = first_unstable(*candidate, amount, move)) {
      Point point = keep(std::move(*unstable), move.control);
      point.landed.emplace_back("bifurcation");
      return point;
    }
    const double strength = releases_at_once_ ? share_to_strength(*candidate) : 1;
    if (const auto crossing = first_crossing(*candidate); crossing && crossing->share <= strength) {
      if (auto point = land(*candidate, *crossing, move.control)) return point;
      why = fmt::format("no step ends on {} = {:g}, which lies on the way", crossing->landing.name,
                        crossing->landing.value);
      amount *= 0.5 * std::max(crossing->share, 0.1);
      continue;
    }
    if (strength < 1) {
      if (auto point = land_on_strength(*candidate, move.control)) return point;
      why = "no step ends where the next point reaches its strength";
      amount *= 0.5 * std::max(strength, 0.1);
      continue;
    }
    resize(*candidate, amount, move);
    note_looks(looked, *candidate);
    memory_.step = std::max(memory_.step, looked_at);  // what was hidden is behind
    return keep(*candidate, move.control);
  }
  if (auto point = rupture()) return point;
  if (control_->may_be_rescued())
    if (auto point = sequential_step("sequentially_linear", memory_.last_quantum)) return point;
  if (const std::string turned = turning_point(); !turned.empty())
    return end(Ending::Kind::stopped_early, turned);
  constexpr double hardly_any = 1e-3;
  if (const double left = std::abs(load_of(walker_.state())) / memory_.peak_load; left < hardly_any)
    return end(Ending::Kind::goal_reached,
               fmt::format("complete rupture: what is left is a mechanism ({:.1e} of the peak)", left));
  if (!walker_.leaving().keeps_equilibrium) {
    unsound_.clear();  // what was refused on the way is not why
    return end(
        Ending::Kind::stopped_early,
        "the path ends here: no rates were found that keep the equilibrium, whichever points crack, unload, "
        "slide and hold; the structure would go on dynamically");
  }
  return end(Ending::Kind::stopped_early,
             fmt::format("{} control found no next equilibrium: {}; {}", move.control, why, what_to_try));
}

/// Where a step fails because the path turns on the way: lands exactly where a crack starts or has lost its
/// last traction, so that the tangent there tells which cracks go on and which unload.
std::optional<Point> Path::land_on_turn(double failed, bool on_new_cracks, const Move& move) {
  if (!walker_.leaving().dissipates || !control_->may_be_rescued()) return {};
  const std::array<std::pair<double, Initiation>, 2> turns{
      {{next_corner(walker_), Initiation::corner},
       {on_new_cracks ? next_new_crack(walker_) : std::numeric_limits<double>::infinity(),
        Initiation::new_one}}};
  const auto& [amount, kind] = std::ranges::min(turns, {}, [](const auto& turn) { return turn.first; });
  if (!(amount < 2 * failed)) return {};
  const Move landing{.control = kind == Initiation::corner ? "corner" : "initiation",
                     .equation = make_event_equation(walker_.system(), kind),
                     .arc = {},
                     .rate = 1,
                     .to_event = true};
  std::string why;
  const auto candidate = try_step(landing, amount, why);
  if (!candidate || first_crossing(*candidate) || before_peak(*candidate) || is_coarse(*candidate)) return {};
  constexpr double progress = 1e-6;  // without it two points would hand the crack to and fro for ever
  const double quantum = memory_.last_quantum;
  if (candidate->dissipated - walker_.here().dissipated <= progress * quantum) return {};
  memory_.step = std::max(memory_.step, amount);
  memory_.step_control = move.control;
  Point point = keep(*candidate, landing.control);
  memory_.last_quantum = std::max(memory_.last_quantum, quantum);
  return point;
}

/// Accepts what a step has jumped to where joints snap: most of what such a jump leaves unaccounted for is
/// left however short the step is, as two of its sizes tell, while that of a kink vanishes with it. How much
/// of the energy that it sets free friction takes on the way is not known.
std::optional<Point> Path::snap(const Candidate& beyond, const Move& move, double amount, Snap& snap) {
  constexpr double most = 0.7;
  const double lost = missing_work(beyond);
  const Snap before = std::exchange(snap, {snap.natural, amount, lost});
  if (before.amount == 0 || !only_touches(beyond)) return {};
  const double left = lost - (before.lost - lost) * amount / (before.amount - amount);
  if (!(left / lost > most)) return {};
  const double spent = beyond.dissipated - walker_.here().dissipated;
  auto point = jump_to(beyond, move.control);
  if (!point) return {};
  memory_.step = snap.natural * unit_of(move);
  report("snapped",
         fmt::format("joints held by friction snap: {:.3e} spent by it and set free", spent + lost));
  return point;
}

std::optional<Candidate> Path::try_step(const Move& move, double amount, std::string& why,
                                        Thoroughness thoroughness) {
  auto candidate = judged(attempt(move, amount, thoroughness), move.control, why);
  if (!candidate || !lies_behind(*candidate, move)) return candidate;
  why = "the event lies behind, where cracks close";
  reject(move.control, why);
  return {};
}

/// Whether the load has gone back on the way to an event although nothing cracks.
bool Path::lies_behind(const Candidate& candidate, const Move& move) const {
  constexpr double round_off = 1e-9;
  const double ahead = candidate.state.load_factor - walker_.state().load_factor;
  const double rate = walker_.leaving().load_factor;
  return move.to_event && !walker_.leaving().dissipates &&
         ahead * rate < -round_off * std::abs(walker_.state().load_factor * rate);
}

/// What an attempt has found, if that is the next point of this path; else it is rejected, and `why` tells.
std::optional<Candidate> Path::judged(const Attempt& tried, const std::string& control, std::string& why) {
  why = tried.reason;
  jumped_.reset();
  if (tried.converged) {
    Candidate candidate = walker_.evaluate(tried);
    why = objection(candidate);
    if (why.empty()) return candidate;
    if (unsound_.empty()) jumped_ = std::move(candidate);
  }
  reject(control, why);
  return {};
}

/// Counts a step that is not taken, and tells the log why.
void Path::reject(const std::string& control, const std::string& why) {
  ++walker_.effort().rejected;
  report("rejected", fmt::format("{}: {}", control, why));
}

Attempt Path::attempt(const Move& move, double amount, Thoroughness thoroughness) {
  if (!move.arc)
    return walker_.attempt(*move.equation, move.to_event ? 1.0 : amount * move.rate, walker_.ahead(amount),
                           thoroughness);
  ArcLength arc = *move.arc;
  arc.length *= amount * move.rate;
  return walker_.attempt(arc);
}

/// Whether more work of the step than `most` is neither stored nor dissipated, nor lost in rounding:
/// quadrature error, or a jump.
bool Path::loses_work(const Candidate& candidate, double most) const {
  const double missing = std::abs(missing_work(candidate));
  return missing > most &&
         missing - walker_.system().rounding_of_work(walker_.state(), candidate.state) > most;
}

/// Whether a step only opens, closes and slides joints, so that many kinks may lie in it.
bool Path::only_touches(const Candidate& candidate) const {
  return !walker_.leaving().dissipates && !candidate.arriving.dissipates && can_slide();
}

/// Whether the quadrature of the work misses a kink within the step: the energy balance of a run is the sum
/// of these.
bool Path::is_coarse(const Candidate& candidate) const {
  constexpr double share = 0.01;  // of the accuracy, twice what the step size aims at
  const double of_sliding = walker_.system().joins_by_contact() ? 0.02 : 0.01;
  const double work = std::abs(candidate.work - walker_.here().work);
  const double fine = share * parameters_.step.accuracy * std::abs(candidate.work);
  return loses_work(candidate, only_touches(candidate) ? std::max(fine, of_sliding * work) : fine);
}

/// Why a converged state is not the next point of this path; "" when it is.
std::string Path::objection(const Candidate& candidate) const {
  if (std::string why = unsoundness(candidate); !why.empty()) return why;
  if (std::string why = energy_objection(candidate); !why.empty()) return why;
  const Candidate& here = walker_.here();
  const double dissipated = candidate.dissipated - here.dissipated, work = candidate.work - here.work;
  constexpr double of_dissipation = 0.1, of_total = 0.02, of_work = 0.01;
  if (loses_work(candidate, of_dissipation * std::max(dissipated, of_total * candidate.dissipated) +
                                of_work * std::abs(work)))
    return fmt::format("the step jumps: {:.1e} of its work is unaccounted for",
                       std::abs(missing_work(candidate) / work));
  const double before = std::abs(load_of(walker_.state())), after = std::abs(load_of(candidate.state));
  if (here.dissipated > 0 && dissipated <= 0 && after < before && walker_.leaving().dissipates)
    return "the step retraces the unloading branch";
  return {};
}

/// Looks beyond the point where a control ends, by dissipation: the control's own word if the path turns
/// against it.
std::string Path::turning_point() {
  if (!walker_.leaving().dissipates) return {};
  const double smallest = std::max(memory_.last_quantum, 1e-4 * walker_.here().dissipated);
  for (const double multiple : {1.0, 10.0, 100.0}) {
    std::string why;
    const auto beyond = try_step(dissipation_move(walker_), multiple * smallest, why);
    if (!beyond) continue;
    if (std::string turned = control_->obstacle(beyond->arriving); !turned.empty()) return turned;
  }
  return {};
}

/// Whether only the weak springs hold the structure any more: it moves far beyond what it did under its peak.
bool Path::is_mechanism(const State& state) const {
  constexpr double far = 100;
  return memory_.largest_displacement > 0 &&
         std::abs(displacement_of(state)) > far * memory_.largest_displacement;
}

}  // namespace dda
