#include <cmath>
#include <limits>

#include "continuation/follow/judge.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

/// A part of the way to an event that cannot be reached in one step, or not without losing track of the
/// energy, because contacts change on the way.
std::optional<Point> approach(PathState& path, double amount) {
  const Move move = load_move(path.walker);
  constexpr double resolved = 0.02;  // of the way: a kink of friction or contact need not be cut finer
  for (double share = 0.5; share > smallest_share; share *= 0.5) {
    const auto candidate = try_step(path, move, share * amount);
    if (!candidate || is_mechanism(path, candidate->state) ||
        (share > resolved && is_coarse(path, *candidate)))
      continue;
    if (const auto crossing = first_crossing(path, *candidate))
      if (auto point = land(path, *candidate, *crossing, move.kind)) return point;
    return keep(path, *candidate, move.kind);
  }
  return {};
}

/// No event was found. Where the structure could not even get there elastically, only weak springs holding it, that is why, whatever
/// Newton's method says of it by rounding.
std::optional<Point> end_before_event(PathState& path, double amount, const std::string& why) {
  Candidate ahead = path.walker.here();
  ahead.state = path.walker.ahead(amount);
  if (const auto unsound = unsoundness(path, ahead)) return path.stop_early(unsound->stop, unsound->text);
  return end_without_equilibrium(path, Stop::next_initiation, "the next initiation was not found: " + why);
}

/// The end of a path along which nothing limits the load, at the full one.
std::optional<Point> full_load(PathState& path) {
  if (path.walker.system().is_damaged())
    return path.stop_early(Stop::no_further_crack, "no interface can crack any further under this load");
  if (!path.walker.system().has_contacts())
    return path.end_with_structure(
        path.walker.system().equilibrium().interfaces().num_crackable() > 0
            ? "nothing cracks under this load, however large; it is applied in full"
            : "nothing can crack; the full reference load is applied");
  return path.end_with_structure(
      path.walker.here().dissipated > 0
          ? "no joint begins or ends to slide, opens or closes under this load, however large; it is applied "
            "in full"
          : "no joint slides, opens or closes under this load, however large; it is applied in full");
}

}  // namespace

std::optional<Point> event_step(PathState& path) {
  const double amount = amount_to_event(path);
  // Of a mechanism, along which no load grows, the next strength is not sought by the load.
  const bool is_free = path.walker.here().dissipated > 0 && moves_freely(path);
  if (!std::isfinite(amount) || (is_free && can_slide(path)))
    return can_slide(path) ? sliding_step(path) : linear_step(path);
  path.control->obstacle(
      path.walker.leaving());  // fixes the direction of a prescribed gauge on the elastic branch
  if (auto point = land_ahead(path, amount)) return point;
  const Move move = event_move(path.walker);
  const auto candidate = try_step(path, move, amount);
  if (!candidate) {
    const std::string why = path.refusal;
    const bool may_jump = path.control->may_be_rescued(),
               jumps_first = may_jump && path.walker.leaving().dissipates;
    if (jumps_first)
      if (auto point = jump_step(path)) return point;
    const double change = path.walker.system().has_contacts() ? next_contact_change(path.walker)
                                                              : std::numeric_limits<double>::infinity();
    const bool slides_on_the_way = change < amount || (can_slide(path) && std::isfinite(change));
    if (slides_on_the_way) return sliding_step(path);
    if (auto point = approach(path, amount)) return point;
    if (can_slide(path)) return sliding_step(path);
    if (may_jump && !jumps_first)
      if (auto point = jump_step(path)) return point;
    return end_before_event(path, amount, why);
  }
  if (is_coarse(path, *candidate)) {
    if (auto point = can_slide(path) ? sliding_step(path) : approach(path, amount)) return point;
    path.ending = {};  // no finer way was found: the event itself stands
  }
  if (const auto crossing = first_crossing(path, *candidate)) {
    if (auto point = land(path, *candidate, *crossing, StepKind::event)) return point;
    if (auto point = land_ahead(path, amount, candidate->dissipated))
      return point;  // friction slides on the way
    if (auto point = approach(path, crossing->share * amount)) return point;
  }
  path.memory.step = 0;
  return keep(path, *candidate, move.kind);
}

std::optional<Point> linear_step(PathState& path) {
  if (!present_goals(path).empty())  // however large a load they take
    if (auto point = land_on_next(path)) return point;
  const double rest = 1 - path.walker.state().load_factor;
  constexpr double round_off = 1e-12;
  if (rest <= round_off) return full_load(path);
  const Move move = load_move(path.walker);
  const auto candidate = try_step(path, move, rest / path.walker.leaving().load_factor);
  const std::string why = path.refusal;
  if (!candidate || is_coarse(path, *candidate)) {
    auto point = approach(path, rest / path.walker.leaving().load_factor);
    if (point || !candidate) return point ? point : path.stop_early(Stop::no_next_equilibrium, why);
  }
  if (const auto crossing = first_crossing(path, *candidate))
    if (auto point = land(path, *candidate, *crossing, move.kind)) return point;
  return keep(path, *candidate, move.kind);
}

}  // namespace dda
