#include <algorithm>
#include <array>
#include <limits>

#include "continuation/follow/judge.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {
namespace {

/// Share of a step from which on a place is landed on: beyond nearer ones a shorter step may lead, and two points could
/// hand a crack or a contact to and fro for ever.
constexpr double hardly = 0.01;

/// Whether what the control prescribes goes on to a place; of one that prescribes no gauge it is told by nothing.
bool goes_on(const PathState& path, const Candidate& candidate) {
  const auto gauge = path.control->held_in_release();
  if (!gauge) return true;
  const double change = candidate.state.value(*gauge) - path.walker.value(*gauge);
  return change * path.walker.leaving().rate(*gauge) > 0;
}

/// Whether a place may be landed on: nothing that a step ends at or looks for lies before it, and its tangent tells the way on.
bool is_next(const PathState& path, const Candidate& candidate) {
  return !candidate.arriving.d.empty() && goes_on(path, candidate) && !first_crossing(path, candidate) &&
         !before_peak(path, candidate) && !is_coarse(path, candidate);
}

}  // namespace

std::optional<Point> land_on_turn(PathState& path, const Stride& stride, bool on_new_cracks) {
  const std::array<std::pair<double, Initiation>, 2> turns{
      {{next_corner(path.walker), Initiation::corner},
       {on_new_cracks ? next_new_crack(path.walker) : std::numeric_limits<double>::infinity(),
        Initiation::new_one}}};
  const auto& [amount, kind] = std::ranges::min(turns, {}, [](const auto& turn) { return turn.first; });
  const bool is_passed_once = kind == Initiation::corner;  // by the point whose curve has it
  if (!(amount < 2 * stride.amount) || (!is_passed_once && amount < hardly * stride.amount)) return {};
  const Move landing{.kind = kind == Initiation::corner ? StepKind::corner : StepKind::initiation,
                     .equation = make_event_equation(path.walker.system(), kind),
                     .rate = 1,
                     .to_event = true};
  const auto candidate = try_step(path, landing, amount);
  if (!candidate || !is_next(path, *candidate)) return {};
  if (path.cracks && share_to_strength(path, *candidate) < 1)
    return land_on_strength(path, *candidate, landing.kind);
  const double quantum = path.memory.last_quantum, progress = is_passed_once ? 0 : 1e-6;
  const double spent = candidate->dissipated - path.walker.here().dissipated;
  if (path.walker.leaving().dissipates && !(spent > progress * quantum)) return {};
  path.memory.step = std::max(path.memory.step, amount * unit_of(path, stride.move));
  path.memory.step_kind = stride.move.kind;
  Point point = keep(path, *candidate, landing.kind);
  path.memory.last_quantum = std::max(path.memory.last_quantum, quantum);
  return point;
}

std::optional<Point> land_on_contact_change(PathState& path, double amount, StepKind kind) {
  const bool may_turn = kind == StepKind::arc_length || path.control->held_in_release();
  if (!path.walker.leaving().dissipates && !may_turn) return {};
  if (!path.walker.system().has_contacts()) return {};
  const auto change = find_contact_change(path.walker);
  if (!change || change->amount >= amount || change->amount < hardly * amount) return {};
  const auto candidate = try_step(path, contact_move(path.walker, *change), change->beyond);
  if (!candidate || !is_next(path, *candidate)) return {};
  if (path.cracks && share_to_strength(path, *candidate) < 1)
    return land_on_strength(path, *candidate, StepKind::corner);
  const BeyondChange passed{change->point, change->across};
  Point point = keep(path, *candidate, StepKind::corner);
  path.walker.leave_beyond(passed);
  return point;
}

std::optional<Point> slide_beside_load(PathState& path) {
  constexpr double little = 3e-6;  // of the structure's size
  const auto change = find_contact_change(path.walker);
  if (!change) return {};
  const Vec2 rate = path.walker.leaving().opening[change->point];
  for (const Vec2& part : {Vec2(0, rate.y()), Vec2(rate.x(), 0)}) {
    if (part.isZero()) continue;
    const Move move = opening_move(path.walker, change->point, part);
    const auto candidate = try_step(path, move, change->amount + little * path.size / move.rate);
    if (candidate && way_beside_load(path, path.walker.state(), candidate->state) > 0)
      return keep(path, *candidate, move.kind);
  }
  return {};
}

}  // namespace dda
