#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/follow/advice.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

/// Prescribes the opening of the joint that moves fastest.
Move fastest_opening(const PathState& path) {
  const std::vector<Vec2>& rates = path.walker.leaving().opening;
  const auto fastest = std::ranges::max_element(rates, {}, [](const Vec2& rate) { return rate.norm(); });
  Move out = opening_move(path.walker, static_cast<std::size_t>(fastest - rates.begin()), *fastest);
  out.kind = StepKind::opening;
  return out;
}

/// The control of a structure that slides: the control's own where it prescribes a gauge, else the displacement on which the load
/// works, which goes on where the load does not, and where neither does what a joint opens by.
Move sliding_move(PathState& path) {
  Move own = path.control->next(path.walker);
  const bool serves = !own.to_event && own.kind != StepKind::dissipation && own.rate != 0;
  if (serves) return own;
  return goes_beside_load(path) ? fastest_opening(path) : displacement_move(path);
}

/// Exactly to where the first joint begins to slide, or opens or closes.
std::optional<Point> first_slip(PathState& path, double change) {
  if (auto point = land_ahead(path, change)) return point;
  const Move move = load_move(path.walker, StepKind::event);
  const auto candidate = try_step(path, move, change);
  if (!candidate) return {};
  path.memory.has_slid = true;
  path.memory.step = 0;
  Point point = keep(path, *candidate, move.kind);
  point.landed.emplace_back("first contact change");
  return point;
}

/// No contact changes any more: up to the full reference load, unless something has happened on the path; that joints slide in
/// proportion to the load from the first of it is nothing, since no load is another one than its parts. What slides goes on:
/// as a mechanism where it takes next to none of what the load has grown by with the displacement so far.
std::optional<Point> linear_for_good(PathState& path) {
  if (!path.walker.leaving().keeps_equilibrium) return path.stop_early(Stop::dynamic, without_rates);
  const bool has_begun = path.walker.state().load_factor != 0;
  if (path.memory.has_slid && hardly_resists_at_once(path))
    return path.end_with_structure(
        fmt::format("the stage '{}' begins where joints slide on under its load, however small",
                    path.walker.system().loading().name));
  if (path.memory.has_slid && hardly_resists(path))
    return path.end_with_structure(fmt::format("joints slide on under this load, at a load factor of {:.9g}",
                                               path.walker.state().load_factor));
  if (path.memory.has_slid || (has_begun && path.walker.system().is_damaged()))
    return path.end_with_structure(
        fmt::format("no joint begins to crack, slide, open or close any more beyond a load factor of {:g}",
                    path.walker.state().load_factor));
  return linear_step(path);
}

/// How far the first of steps that slide goes, `change` being the distance of the next contact change. What moves on as a
/// mechanism, as what rocks back under another load than has opened it, takes next to no load: there it is a part of the way to that
/// change, or a little of the structure's size where that is less.
double first_sliding_amount(const PathState& path, const Move& move, double change) {
  constexpr double part = 0.25, little = 1e-3, slip = 1e-5, hardly = 0.002;
  if (move.kind == StepKind::opening && goes_beside_load(path)) return slip * path.size / move.rate;
  const bool is_loaded = path.walker.here().stored > 0;
  const Tangent& leaving = path.walker.leaving();
  double amount = is_loaded && std::isfinite(change) ? part * change : 1 / std::abs(leaving.load_factor);
  if (path.memory.has_slid && is_loaded)  // a stage that begins: by a little of the forces that act
    amount = std::min(
        amount, part * hardly * path.as_load(path.memory.largest_force) / std::abs(leaving.rate(path.load)));
  const bool has_load = std::abs(path.load_of(path.walker.state())) > path.smallest_load();
  if (path.memory.has_slid && is_loaded && has_load)
    amount = part * std::abs(path.walker.state().load_factor / leaving.load_factor);
  amount = std::max(amount, sliding_amount(path));
  const double moved = std::abs(path.displacement_rate(leaving));
  if (moved * amount <= little * path.size) return amount;
  return std::min(part * change, little * path.size / moved);
}

}  // namespace

std::optional<Point> sliding_step(PathState& path) {
  const bool is_untouched = path.walker.here().dissipated == 0 && !path.memory.has_slid;
  const auto obstacle = path.control->obstacle(path.walker.leaving());
  const bool may_move_yet = is_untouched && obstacle && obstacle->stop == Stop::gauge_stands;
  if (obstacle && !may_move_yet) return path.stop_early(obstacle->stop, obstacle->text);
  const double change = next_contact_change(path.walker), goal = amount_to_landing(path);
  const bool is_loaded = path.walker.here().stored > 0;
  if (!std::isfinite(change) && is_loaded) {
    const bool may_crack = std::isfinite(next_event(path.walker));
    if (!std::isfinite(goal) && !may_crack && !moves_freely(path)) return linear_for_good(path);
    if (auto point = land_on_next(path)) return point;
  }
  const bool is_far = std::isfinite(change) &&
                      std::abs(path.walker.leaving().rate(path.load)) * change > path.smallest_load();
  if (is_far && is_untouched)
    if (auto point = first_slip(path, change)) return point;
  const Move move = sliding_move(path);
  if (path.memory.step == 0 || path.memory.step_kind != move.kind) {
    path.memory.step = first_sliding_amount(path, move, change) * unit_of(path, move);
    path.memory.step_kind = move.kind;
  }
  const Departure before(path.walker);
  auto point = controlled_step(path, move);
  if (point) {
    path.memory.has_slid = path.memory.has_slid || std::isfinite(change);
    note_mechanism(path, *point, before);
  }
  return point;
}

}  // namespace dda
