#include <fmt/format.h>

#include <cmath>

#include "continuation/detour/release.hpp"
#include "continuation/follow/judge.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

/// Whether a release has turned the load round while contacts changed: an equilibrium that it does not lead
/// to. A straight piece may do so.
bool turns_load_round(const PathState& path, const ReleasedPiece& piece) {
  constexpr double hardly = -0.1;  // what is held by friction after unloading
  const double before = path.walker.state().load_factor;
  return !piece.is_straight && before != 0 && piece.end.state.load_factor / before < hardly;
}

/// A release only as far as a straight one takes a gauge to a wanted value.
std::optional<Point> release_up_to(PathState& path, const Crossing& crossing, const Functional* held,
                                   double most) {
  const Landing& landing = crossing.landing;
  const double share = crossing.share * most;
  const auto found = release_piece(path.walker.stepper(), path.walker.state(), {held, share});
  if (!found) return {};
  const State& at = found->end.state;
  const double off = std::abs(at.value(landing.gauge) - landing.value);
  if (off > same_value * std::abs(landing.value - path.walker.value(landing.gauge))) return {};
  auto point = jump_to(path, path.walker.settled(found->end), StepKind::release);
  if (point) point->landed.push_back(fmt::format("{}={:g}", landing.name, landing.value));
  return point;
}

/// The farthest vertex, of some, to which a release leads. Where contacts change on the way the path is not
/// straight, and its end is told from another equilibrium by going less far.
std::optional<Point> release_holding(PathState& path, const Functional* held) {
  constexpr double nearest = 0.05, of_spent = 0.1, of_work = 1e-3;
  const Candidate& here = path.walker.here();
  for (double most = 1; most > nearest; most *= cut) {
    const auto found = release_piece(path.walker.stepper(), path.walker.state(), {held, most});
    if (!found || is_mechanism(path, found->end.state) || turns_load_round(path, *found)) continue;
    Candidate beyond = path.walker.settled(found->end);
    const double spent = std::abs(beyond.dissipated - here.dissipated),
                 work = std::abs(beyond.work - here.work);
    const bool is_straight = !loses_work(path, beyond, of_spent * spent + of_work * work);
    if (!is_straight && most * cut > nearest) continue;
    if (const auto crossing = first_crossing(path, beyond))
      if (auto point = release_up_to(path, *crossing, held, most)) return point;
    if (auto point = jump_to(path, std::move(beyond), StepKind::release)) return point;
  }
  return {};
}

/// What a test finds that prescribes the displacement on which the load works: the pending points lose their
/// strength while it is held, together or at last at once; else the largest of some shares of the load.
std::optional<Point> release_by_jump(PathState& path) {
  Stepper& stepper = path.walker.stepper();
  const State start = path.walker.state();
  const auto accepted = [&](const std::optional<Settled>& found) {
    if (!found || is_mechanism(path, found->state)) return std::optional<Point>();
    return jump_to(path, path.walker.settled(*found), StepKind::release);
  };
  std::optional<Point> point;
  const auto piece = release_piece(stepper, start, {&path.displacement});
  if (piece) point = accepted(piece->end);
  if (!point)
    point = accepted(release_at_gauge(stepper, start, {path.displacement, path.displacement_of(start)}));
  for (const double share : {1.0, 0.9, 0.75, 0.5, 0.25, 0.1})
    if (!point) point = accepted(release_at_load(stepper, start, share * start.load_factor));
  if (!point)
    return end_without_equilibrium(path, Stop::release_held, "what is released leaves no equilibrium");
  ++path.walker.effort().rescues;
  path.report("rescued", fmt::format("the release jumped from a load factor of {:g} to {:g}",
                                     start.load_factor, path.walker.state().load_factor));
  return point;
}

}  // namespace

std::optional<Point> release_step(PathState& path) {
  const auto held = path.control->held_in_release();
  if (auto point = release_holding(path, held ? &*held : nullptr)) return point;
  if (!path.control->may_be_rescued())
    return path.stop_early(
        Stop::release_held,
        held ? "failure: what is released leaves no equilibrium under this control; use `staged`"
             : "what is released leaves no equilibrium");
  return release_by_jump(path);
}

}  // namespace dda
