#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "continuation/follow/advice.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

Outcome climb(PathState& path, const Candidate& candidate, Stride& stride) {
  for (const Rung rung : rungs)
    if (auto outcome = rung(path, candidate, stride)) return *std::move(outcome);
  return {};
}

/// A step as long as the stride. Where it would pass the strength of a point that a crack waits for, which must not
/// crack before the crack has grown, it is the one that ends there.
std::optional<Candidate> tried(PathState& path, Stride& stride, Thoroughness thoroughness) {
  stride.beyond = 0;
  if (path.cracks) {
    Candidate ahead = path.walker.here();
    ahead.state = path.walker.ahead(stride.amount);
    if (const double share = share_to_strength(path, ahead); share < 1)
      if (auto candidate = at_strength(path, ahead, stride.move.kind)) {
        stride.beyond = stride.amount;
        stride.amount *= share;
        return candidate;
      }
  }
  return try_step(path, stride.move, stride.amount, thoroughness);
}

/// A try that found no next point: where the load ends or the path turns before its end, there.
Outcome after_failure(PathState& path, Stride& stride, bool is_cut) {
  if (path.load_of(path.walker.ahead(stride.amount / path.parameters.step.cut)) <= 0)
    if (auto point = rupture(path)) return {std::move(point)};
  if (path.is_refused_beside_load)
    if (auto point = slide_beside_load(path)) return {std::move(point)};
  const bool is_again = stride.cuts++ > 0;
  if (auto point = land_on_turn(path, stride, is_cut || is_again)) return {std::move(point)};
  if (is_again)
    if (auto point = land_on_contact_change(path, stride.amount, stride.move.kind)) return {std::move(point)};
  stride.amount *= path.parameters.step.cut;
  return {};
}

/// Looks beyond the point where a control ends, by dissipation: the control's own word if the path turns
/// against it.
std::optional<Stopped> turning_point(PathState& path) {
  if (!path.walker.leaving().dissipates) return {};
  const double smallest = std::max(path.memory.last_quantum, 1e-4 * path.walker.here().dissipated);
  for (const double multiple : {1.0, 10.0, 100.0}) {
    const auto beyond = try_step(path, dissipation_move(path.walker), multiple * smallest);
    if (!beyond) continue;
    if (auto turned = path.control->obstacle(beyond->arriving)) return turned;
  }
  return {};
}

/// How a path of joints that only touch goes on where what a control prescribes does not: at a constant load.
Stopped moves_on(StepKind control, double load_factor) {
  if (control == StepKind::load)
    return {
        Stop::limit_point,
        fmt::format(
            "the load rises no further: at a load factor of {:.9g} the structure moves on as a mechanism, "
            "which load control cannot follow; use `staged` or `displacement`",
            load_factor)};
  return {
      Stop::gauge_stands,
      fmt::format(
          "at a load factor of {:.9g} the structure moves on as a mechanism while the gauge that {} control "
          "prescribes stands; use `staged`, or a gauge that moves with it",
          load_factor, to_string(control))};
}

/// Looks beyond the last point that the control of a gauge or of the load could reach, by the displacement on which the load
/// works: where that goes on and the load falls or the gauge goes back, the control's own word; where the load stays, at once
/// or after the last corners before it, what slides or turns is a mechanism under it.
std::optional<Stopped> beyond_control(PathState& path, const Move& move) {
  const auto gauge = path.control->held_in_release();
  if (!gauge || !path.walker.system().has_contacts()) return {};
  const State& here = path.walker.state();
  double load = path.load_of(here);
  constexpr double hardly = 1e-6;
  const double along = mechanism_way * std::abs(path.displacement_of(here));
  const Move by_displacement = displacement_move(path);
  if (by_displacement.rate == 0 || along == 0) return {};
  for (const double multiple : {1.0, 10.0, 100.0}) {
    const auto beyond = try_step(path, by_displacement, multiple * along / std::abs(by_displacement.rate),
                                 Thoroughness::full);
    if (!beyond) continue;
    Tangent way = beyond->arriving;
    way.d = beyond->state.d.combined(1, -1, here.d);
    way.load_factor = beyond->state.load_factor - here.load_factor;
    const double before = std::exchange(load, path.load_of(beyond->state)),
                 moved = std::abs(path.displacement_of(beyond->state) - path.displacement_of(here));
    const bool stays = std::abs(load - before) <= standing_load(path, load);
    const bool turns = move.kind == StepKind::load ? !stays : std::abs(way.rate(*gauge)) > hardly * moved;
    if (turns)
      if (auto turned = path.control->obstacle(way)) return turned;
    if (stays && (multiple > 1 || is_free_beyond(path)))
      return moves_on(move.kind, beyond->state.load_factor);
  }
  return {};
}

/// Whether nothing is loaded yet, where joints that only touch ask the same of a small load as of a large one.
bool is_at_rest(const PathState& path) {
  return path.walker.system().has_contacts() && path.walker.state().load_factor == 0 &&
         path.walker.here().stored == 0;
}

/// Whether an arc leads no farther that the displacement on which the load works may still lead on: at corners where bodies
/// that only touch begin to part, openings before and after may all but be at right angles, and iterated multipliers, held
/// meanwhile, turn them farther.
bool has_no_arc(const PathState& path, const Move& move) {
  return move.kind == StepKind::arc_length && path.walker.system().joins_by_contact();
}

/// What every step is longer than; one of `path.step.shortest` itself is.
double shortest_amount(const PathState& path, const Move& move) {
  constexpr double round_off = 1e-12;
  return (1 - round_off) * path.parameters.step.shortest.value_or(0) / std::abs(move.rate);
}

/// Steps of `path.step.shortest` or more lead no farther; whether shorter ones would is not known.
std::optional<Point> end_of_steps(PathState& path, const Stride& stride) {
  const auto turned = turning_point(path);
  path.unsound.reset();  // what was refused on the way is not why
  return path.stop_early(
      Stop::no_next_equilibrium,
      fmt::format(
          "{} control would need steps shorter than path.step.shortest ({:g}): {}; allow shorter ones, or "
          "another `path.control`",
          to_string(stride.move.kind), *path.parameters.step.shortest, turned ? turned->text : stride.why));
}

/// Why a path ends whose control finds no next equilibrium.
std::optional<Point> end_of_control(PathState& path, const Stride& stride) {
  if (const auto turned = turning_point(path)) return path.stop_early(turned->stop, turned->text);
  const auto refused = path.unsound;
  const auto limit = beyond_control(path, stride.move);
  path.unsound = limit ? std::nullopt : refused;  // what is refused beyond the end is not why
  if (limit) return path.stop_early(limit->stop, limit->text);
  constexpr double hardly_any = 1e-3;
  const double left = path.share_of_peak();
  if (left < hardly_any && !bears_load(path))
    return path.end_with_structure(
        fmt::format("complete rupture: what is left is a mechanism ({:.1e} of the peak)", left));
  if (!path.walker.leaving().keeps_equilibrium) {
    path.unsound.reset();  // what was refused on the way is not why
    return path.stop_early(Stop::dynamic, without_rates);
  }
  if (is_at_rest(path))
    return path.stop_early(
        Stop::no_next_equilibrium,
        fmt::format("no equilibrium was found under the load, however small: {}; what it pushes may "
                    "slide off, which friction holds only where the load leans by less than its "
                    "angle",
                    stride.why));
  return path.stop_early(
      Stop::no_next_equilibrium,
      fmt::format("{} control found no next equilibrium: {}; {}", to_string(stride.move.kind), stride.why,
                  what_to_try(path.walker.system().equilibrium())));
}

}  // namespace

std::optional<Point> controlled_step(PathState& path, const Move& move) {
  const bool known = path.memory.step > 0 && path.memory.step_kind == move.kind;
  const double first =
      bounded(path, move, known ? path.memory.step / unit_of(path, move) : first_amount(path, move));
  if (path.load_of(path.walker.ahead(first)) <= 0 && path.load_of(path.walker.state()) > 0)
    if (auto point = rupture(path)) return point;
  Stride stride{.move = move,
                .amount = first,
                .natural = std::max(first, bounded(path, move, first_amount(path, move))),
                .why = "the tangent does not tell how far a step may go"};
  const double shortest = shortest_amount(path, move);
  if (first < shortest)
    stride.why = fmt::format("the next one is to be {:.3g} long", first * std::abs(move.rate));
  while (stride.amount > std::max(smallest_share * first, shortest)) {
    const Thoroughness thoroughness = thoroughness_of(stride.amount / stride.natural);
    const bool is_cut = thoroughness == Thoroughness::full;
    const bool is_last = stride.amount * path.parameters.step.cut <= shortest;
    const auto candidate = tried(path, stride, is_last ? Thoroughness::full : thoroughness);
    if (!candidate) stride.why = path.refusal;
    Outcome outcome = candidate ? climb(path, *candidate, stride) : after_failure(path, stride, is_cut);
    if (outcome.point) return std::move(outcome.point);
  }
  if (auto point = rupture(path)) return point;
  if (shortest > smallest_share * first) return end_of_steps(path, stride);
  if (has_no_arc(path, move)) return controlled_step(path, displacement_move(path));
  if (path.control->may_be_rescued())
    if (auto point = jump_step(path)) return point;
  return end_of_control(path, stride);
}

}  // namespace dda
