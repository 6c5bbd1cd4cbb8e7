#include "continuation/path/take_step.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "continuation/detour/release.hpp"
#include "continuation/follow/advice.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/step/steps.hpp"
#include "continuation/walk/snap_back.hpp"

namespace dda {

namespace {

/// Leaves an equilibrium from which nothing leads on with the live forces by what leads on against them, if anything does.
/// Of the controls only arc length follows that; others jump, or end.
void snap_back(Walker& walker) {
  if (walker.leaving().keeps_equilibrium) return;
  System& system = walker.system();
  std::vector<History> flags = system.history();
  system.set_history(walker.here().history);
  if (auto way = snapping_tangent(system, walker.state(), walker.here().arriving))
    walker.turn_to(*std::move(way), system.history());
  else
    system.set_history(std::move(flags));
}

/// Under the control; where all that has cracked slides on under the load that friction bears, a mechanism.
std::optional<Point> cracking_step(PathState& path, const Move& move) {
  if (!path.walker.system().has_contacts()) return controlled_step(path, move);
  const Departure before(path.walker);
  auto point = controlled_step(path, move);
  if (point && move.kind == StepKind::arc_length) snap_back(path.walker);
  constexpr double carried = 1e-3;
  if (point && path.load_of(path.walker.state()) > carried * path.memory.peak_load)
    note_mechanism(path, *point, before);
  return point;
}

/// The control's own; where a mechanism goes on while next to nothing is spent, and no arc is long beside the corner at which
/// it has begun, by its displacement, and so where no rates tell an arc which way to go.
Move cracking_move(PathState& path) {
  Move own = path.control->next(path.walker);
  const bool yields = own.kind == StepKind::arc_length ||
                      (own.kind == StepKind::dissipation && path.control->may_be_rescued());
  const bool is_lost = own.kind == StepKind::arc_length && !path.walker.leaving().keeps_equilibrium;
  const bool is_free = yields && path.walker.system().has_contacts() && (is_lost || moves_freely(path));
  return is_free ? displacement_move(path) : own;
}

std::optional<Point> next_step(PathState& path) {
  if (path.leg().unloads) return unload_step(path);
  if (path.releases_at_once && path.control->load_increment() == 0 &&
      is_release_pending(path.walker.system()))
    return release_step(path);
  if (path.walker.leaving().d.empty())
    return path.stop_early(Stop::singular,
                           fmt::format("the tangent stiffness is singular here: a part is free to move; {}",
                                       what_to_try(path.walker.system().equilibrium())));
  const bool cracked = path.walker.here().dissipated > 0 || path.walker.leaving().dissipates;
  if (path.control->load_increment() > 0) return increment_step(path);
  if (!cracked) return event_step(path);
  if (auto point = reload_step(path)) return point;
  if (const auto obstacle = path.control->obstacle(path.walker.leaving()))
    return path.stop_early(obstacle->stop, obstacle->text);
  // What slides beside its load does so whatever still softens.
  if (path.walker.leaving().dissipates && path.control->may_be_rescued() && goes_beside_load(path))
    return sliding_step(path);
  const Move move = cracking_move(path);
  const bool between_releases =
      path.releases_at_once && !path.walker.leaving().dissipates && std::isfinite(next_event(path.walker));
  if (!move.to_event && !between_releases) return cracking_step(path, move);
  if (!path.walker.leaving().dissipates) return event_step(path);
  auto point = sequential_step(path);
  if (point || path.ending.kind != Ending::Kind::running) return point;
  if (!std::isfinite(next_event(path.walker)))
    return path.stop_early(Stop::no_further_crack, "no interface limits the load any more");
  return end_without_equilibrium(
      path, Stop::no_next_equilibrium,
      "event control found no equilibrium at which the next joint reaches its strength" +
          (path.refusal.empty() ? "" : ": " + path.refusal));
}

}  // namespace

std::optional<Point> take_step(PathState& path) {
  if (const auto crack = crack_to_grow(path)) return growth_step(path, *crack);
  if (!path.cracks) return next_step(path);
  if (const auto asked = crack_to_start(path))
    if (auto point = start_step(path, *asked); point || path.ending.kind != Ending::Kind::running)
      return point;
  const PlaceBefore before(path);
  auto point = next_step(path);
  const auto crack = point ? crack_to_grow(path) : std::nullopt;
  if (!crack) return point;
  if (auto aimed = aim_step(path, *crack, before)) return aimed;
  return crack_to_grow(path) ? std::move(point) : take_step(path);
}

}  // namespace dda
