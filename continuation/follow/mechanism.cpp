#include "continuation/follow/mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "continuation/contact/contact_piece.hpp"
#include "continuation/follow/goals.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/state/history_guard.hpp"
#include "continuation/state/residual_stiffness.hpp"

namespace dda {
namespace {

/// How many joints have slid in the last step and how many are apart, and how far it has moved them.
struct ContactMotion {
  std::ptrdiff_t slide = 0, open = 0;
  double slip = 0, parting = 0;  ///< largest [L]
};

/// Whether what moves slides: nothing is open, friction spends what the load does, or, where that does nothing, joints slide as
/// far as others part; a stair parts at its risers as it slides.
bool slides(const PathState& path, const Departure& before, const ContactMotion& moving) {
  if (moving.slide > 0 && moving.open == 0) return true;
  const double load = std::abs(path.load_of(path.walker.state()));
  if (load <= path.smallest_load()) return moving.slide > 0 && moving.slip > 0.5 * moving.parting;
  const double along =
      std::abs(path.displacement_of(path.walker.state()) - path.displacement_of(before.state));
  return path.walker.here().dissipated - before.dissipated > 0.5 * load * along;
}

ContactMotion contact_motion(const Walker& walker, const State& before) {
  const System& system = walker.system();
  const LawValues laws = system.laws(walker.state());
  const std::vector<Vec2> from = system.laws(before).opening;
  ContactMotion out;
  std::vector<double> slips;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const History& h = system.history()[p];
    const auto contact = point.law->contact(h, point.stiffness);
    if (!contact) continue;
    const Vec2 moved = laws.opening[p] - from[p];
    const ContactPiece piece = piece_at(*contact, laws.opening[p], h.sliding);
    if (piece == ContactPiece::open) {
      ++out.open;
      out.parting = std::max(out.parting, std::abs(moved.x()));
    } else if (piece != ContactPiece::stuck) {
      slips.push_back(std::abs(moved.y()));
      out.slip = std::max(out.slip, slips.back());
    }
  }
  constexpr double noticeable = 0.01;  // what stands at its limit without moving is a matter of rounding
  out.slide = std::ranges::count_if(slips, [&](double slip) { return slip > noticeable * out.slip; });
  return out;
}

/// Whether a load has hardly changed.
bool is_same(const PathState& path, double load, double before) {
  constexpr double same = 1e-3;
  return std::abs(load - before) <= std::max(same * std::abs(load), path.smallest_load());
}

/// Displacement of the load, or how far joints have moved beside it, at least what the shortening of stiff supports may be [L].
double way_of_mechanism(const PathState& path) {
  constexpr double gap = 1e-6;  // of the structure's size
  return std::max(
      {std::abs(path.displacement_of(path.walker.state())), path.memory.beside_way, gap * path.size});
}

/// How far the load has moved the structure before a step; strains, which may hardly move what is held, by what they have
/// stored.
double way_before(const PathState& path, double displacement) {
  const double load = std::abs(path.load_of(path.walker.state())), stored = path.walker.here().stored;
  if (path.walker.system().loading().load_is_force || load <= path.smallest_load())
    return std::abs(displacement);
  return std::max(std::abs(displacement), stored / load);
}

/// Whether the structure has moved to three times where it was while the load hardly changed, what it gave on the way other
/// loads took, not storage or spending, and a crack still grows: a mechanism whose joints have not quite given way, as in the
/// tail of a softening curve, followed in steps that are short for their sake.
bool drifts(PathState& path, double load) {
  constexpr double far = 3, little = 0.01;
  PathMemory& memory = path.memory;
  const Candidate& here = path.walker.here();
  const double way = std::abs(path.displacement_of(here.state)), energy = here.stored + here.dissipated;
  const bool stands = memory.standing_way > 0 && is_same(path, load, memory.standing_load);
  if (stands && way < far * memory.standing_way) return false;
  const bool out = stands && std::abs(energy - memory.standing_energy) <=
                                 little * std::abs(load) * (way - memory.standing_way);
  memory.standing_way = way;
  memory.standing_load = load;
  memory.standing_energy = energy;
  return out && path.walker.leaving().dissipates;
}

/// Whether the load has stayed, but for rounding, while the structure moved on by a part of its way, in one step or in many.
bool stays(PathState& path, double load, const State& before) {
  PathMemory& memory = path.memory;
  const double load_before = path.load_of(before), standing = standing_load(path, load);
  if (!(std::abs(load - memory.plateau_load) <= standing)) {
    memory.plateau_load = load_before;
    memory.plateau_way = path.displacement_of(before);
  }
  const double along = std::abs(path.displacement_of(path.walker.state()) - memory.plateau_way);
  return std::abs(load - memory.plateau_load) <= standing &&
         along >= mechanism_way * way_before(path, memory.plateau_way);
}

/// Whether a load that stands while a crack grows does so much farther on, as on the tail of what softens; at its strength, where
/// the load is highest, it does not.
bool stays_on(PathState& path, double load) {
  constexpr double far = 30, hardly = 0.01, large = 0.01;  // the last of the structure's size
  const double way = way_of_mechanism(path);
  if (std::abs(load) <= path.smallest_load() || way > large * path.size) return true;
  const Move move = displacement_move(path);
  if (move.rate == 0) return false;
  const double amount = std::min(far * way, large * path.size) / std::abs(move.rate);
  const auto beyond = try_step(path, move, amount, Thoroughness::full);
  return beyond && std::abs(path.load_of(beyond->state) - load) <= hardly * std::abs(load);
}

/// Whether the structure begins to move as a mechanism, none before or one under another load, which has locked.
bool sets_out(PathState& path, double load) {
  PathMemory& memory = path.memory;
  if (memory.mechanism_way > 0 && is_same(path, load, memory.mechanism_load)) return false;
  memory.beside_way = 0;
  memory.mechanism_way = way_of_mechanism(path);
  memory.mechanism_load = load;
  memory.mechanism_share = 0;
  return true;
}

/// Whether a mechanism has moved three times as far as where it set out, or last brought one of the goals nearer.
bool goes_on_beside(PathState& path, const std::vector<Landing>& goals) {
  constexpr double far = 3, nearer = 0.01, nothing = 1e-4;
  PathMemory& memory = path.memory;
  double share = 0;
  for (const Landing& goal : goals) share = std::max(share, share_of_way(path, goal));
  const double way = way_of_mechanism(path);
  if (share > memory.mechanism_share + nearer * std::max(memory.mechanism_share, nothing)) {
    memory.mechanism_way = way;
    memory.mechanism_share = share;
  }
  return way > far * memory.mechanism_way;
}

/// Along which the structure would bear the live load anew, nothing cracking or sliding on; empty when it is singular.
Tangent reloading(Walker& walker) {
  System& system = walker.system();
  const HistoryGuard back(system);
  std::vector<History> still = system.history();
  for (History& h : still) h.loading = h.sliding = false;
  system.set_history(std::move(still));
  return arriving_tangent(system, walker.state());
}

/// Whether a mechanism has come to its end in the step that led here, a joint having closed: to move on takes load, and far
/// more of it than weak springs and the friction that they bring about.
bool has_locked(const PathState& path, double load) {
  constexpr double noticeable = 1e-3, far = 100;
  const Tangent& leaving = path.walker.leaving();
  const double moved = std::abs(path.displacement_rate(leaving)), rate = std::abs(load_rate(path)),
               along = mechanism_way * std::abs(path.displacement_of(path.walker.state()));
  return rate * along > noticeable *
                            std::max(std::abs(load), noticeable * path.as_load(path.memory.largest_force)) *
                            moved &&
         rate * moved > far * residual_power(path.walker.system().equilibrium(), leaving.opening);
}

/// Rate of the joint that moves fastest along a tangent.
double fastest_rate(const Tangent& along) {
  double out = 0;
  for (const Vec2& rate : along.opening) out = std::max(out, rate.norm());
  return out;
}

/// Whether a joint that is open closes within an amount of the leaving tangent.
bool closes_within(const PathState& path, double amount) {
  constexpr double noticeable = 1e-6;
  const System& system = path.walker.system();
  const std::vector<Vec2>& rates = path.walker.leaving().opening;
  const std::vector<Vec2> opening = system.laws(path.walker.state()).opening;
  const double fastest = fastest_rate(path.walker.leaving());
  for (std::size_t p = 0; p < opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const double closing = -rates[p].x();
    if (closing <= noticeable * fastest) continue;
    const auto contact = point.law->contact(system.history()[p], point.stiffness);
    const double gap = contact ? opening[p].x() + contact->shift : 0;
    if (gap > 0 && gap < amount * closing) return true;
  }
  return false;
}

}  // namespace

bool is_mechanism(const PathState& path, const State& state) {
  constexpr double far = 100;
  return path.memory.largest_displacement > 0 &&
         std::abs(path.displacement_of(state)) > far * path.memory.largest_displacement;
}

double amount_to_event(const PathState& path) {
  const double amount = next_event(path.walker);
  const bool is_far = path.releases_at_once && std::isfinite(amount) && path.walker.system().has_contacts() &&
                      is_mechanism(path, path.walker.ahead(amount));
  return is_far ? std::numeric_limits<double>::infinity() : amount;
}

bool can_slide(const PathState& path) {
  return path.walker.system().has_contacts() &&
         !(path.releases_at_once && std::isfinite(amount_to_event(path)));
}

double way_of_leg(const PathState& path, const State& state) {
  return std::abs(path.displacement_of(state) - path.memory.way_from);
}

double standing_load(const PathState& path, double load) {
  constexpr double same = 1e-6,
                   of_none = 0.1;  // the path's tolerance without the margin of what counts as no load
  return std::max(same * std::abs(load), of_none * path.smallest_load());
}

double way_beside_load(const PathState& path, const State& from, const State& to) {
  constexpr double far = 100, gap = 1e-6;  // the latter of the structure's size
  constexpr double same = 1e-4;            // of the load
  const System& system = path.walker.system();
  if (!system.has_contacts()) return 0;
  const std::vector<Vec2> before = system.laws(from).opening, after = system.laws(to).opening;
  std::vector<Vec2> way(after.size());
  double moved = 0;
  for (std::size_t p = 0; p < after.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    way[p] = after[p] - before[p];
    if (way[p].norm() > moved && point.law->contact(system.history()[p], point.stiffness))
      moved = way[p].norm();
  }
  const double along = path.as_length(std::abs(path.displacement_of(to) - path.displacement_of(from)));
  if (moved <= std::max(far * along, gap * path.size)) return 0;
  const double load = path.load_of(to), change = std::abs(load - path.load_of(from)),
               of_weak_springs = path.as_load(far * residual_power(system.equilibrium(), way) / moved);
  return change <= std::max({same * std::abs(load), standing_load(path, load), of_weak_springs}) ? moved : 0;
}

bool goes_beside_load(const PathState& path) {
  constexpr double far = 100;
  if (path.memory.moves_beside_load) return true;
  const Tangent& leaving = path.walker.leaving();
  const System& system = path.walker.system();
  if (!system.has_contacts()) return false;
  const double fastest = fastest_rate(leaving);
  return fastest > far * path.as_length(std::abs(path.displacement_rate(leaving))) &&
         std::abs(leaving.rate(path.load)) * fastest <=
             path.as_load(far * residual_power(system.equilibrium(), leaving.opening));
}

std::string too_far_beside_load(const PathState& path, const Candidate& candidate) {
  constexpr double gap = 1e-5;  // of the structure's size
  if (path.memory.moves_beside_load || path.control->held_in_release()) return {};
  const double moved = way_beside_load(path, path.walker.state(), candidate.state);
  if (moved <= gap * path.size) return {};
  return fmt::format(
      "joints slide or part by {:.2g} while neither the load nor the displacement on which it works moves",
      moved);
}

double load_rate(const PathState& path) {
  const Tangent& leaving = path.walker.leaving();
  const double moved = path.displacement_rate(leaving), rate = leaving.rate(path.load);
  if (moved == 0 || !path.walker.system().joins_by_contact()) return rate;
  return rate - residual_power(path.walker.system().equilibrium(), leaving.opening) / moved;
}

bool moves_freely(const PathState& path) {
  const double moved = std::abs(path.displacement_rate(path.walker.leaving())),
               along = mechanism_way * std::abs(path.displacement_of(path.walker.state()));
  return moved > 0 &&
         std::abs(load_rate(path)) * along / moved <= standing_load(path, path.load_of(path.walker.state()));
}

bool hardly_resists(const PathState& path) {
  constexpr double hardly = 1e-3;
  const double moved = std::abs(path.displacement_rate(path.walker.leaving())),
               so_far = std::abs(path.displacement_of(path.walker.state()));
  return moved > 0 &&
         std::abs(load_rate(path)) * so_far <= hardly * moved * std::abs(path.load_of(path.walker.state()));
}

bool hardly_resists_at_once(const PathState& path) {
  constexpr double hardly = 1e-3;
  const double moved = std::abs(path.displacement_rate(path.walker.leaving()));
  return path.walker.state().load_factor == 0 && moved > 0 &&
         std::abs(load_rate(path)) * way_of_mechanism(path) <=
             hardly * moved * path.as_load(path.memory.largest_force);
}

bool bears_load(PathState& path, double within) {
  const Tangent anew = reloading(path.walker);
  if (anew.d.empty()) return false;
  const double moved = std::abs(path.displacement_rate(anew)), load = std::abs(anew.rate(path.load));
  return moved * path.memory.peak_load <= within * path.memory.largest_displacement * load;
}

Move displacement_move(const PathState& path) {
  return {.kind = StepKind::displacement,
          .equation = make_gauge_equation(path.displacement),
          .rate = path.displacement_rate(path.walker.leaving())};
}

bool is_free_beyond(const PathState& path) {
  constexpr double far = 100, large = 0.01;  // the latter of the structure's size
  double rate = std::abs(path.displacement_rate(path.walker.leaving()));
  const double way = way_of_mechanism(path), fastest = fastest_rate(path.walker.leaving());
  if (rate < fastest / far) rate = fastest;
  if (rate == 0) return false;
  const double gone = path.memory.mechanism_way > 0 ? way / path.memory.mechanism_way : 0,
               share = way / path.size;
  const bool has_gone_far = (gone > far && share > 0.1 * large) || (gone > 3 && share > large);
  return has_gone_far || !closes_within(path, far * way / rate);
}

namespace {

/// A mechanism that hardly anything holds has a tangent that is singular to the last digit: it moves on as it has moved.
void go_on_as_before(PathState& path, const State& before) {
  Walker& walker = path.walker;
  const State& here = walker.state();
  Tangent along{.d = here.d.combined(1, -1, before.d), .load_factor = here.load_factor - before.load_factor};
  std::ranges::transform(here.multipliers, before.multipliers, std::back_inserter(along.multipliers),
                         std::minus{});
  std::ranges::transform(walker.system().laws(here).opening, walker.system().laws(before).opening,
                         std::back_inserter(along.opening), std::minus{});
  walker.turn_to(std::move(along), walker.system().history());
}

}  // namespace

void note_mechanism(PathState& path, Point& point, const Departure& before) {
  const double load = path.load_of(path.walker.state());
  if (path.walker.leaving().d.empty()) {  // else singular: the next step says so
    if (path.memory.is_mechanism && stays(path, load, before.state)) go_on_as_before(path, before.state);
    return;
  }
  const double beside = way_beside_load(path, before.state, path.walker.state());
  path.memory.moves_beside_load = beside > 0;
  path.memory.beside_way += beside;
  const bool is_same_load = std::abs(load - path.load_of(before.state)) <= standing_load(path, load);
  const bool stands = stays(path, load, before.state) &&
                      (!path.walker.leaving().dissipates || stays_on(path, load)),
             is_free = stands || (path.memory.moves_beside_load && is_same_load),
             is_drift = drifts(path, load);
  if (!is_free && !is_drift) return;
  const ContactMotion moving = contact_motion(path.walker, before.state);
  const double factor = std::abs(load) > path.smallest_load() ? path.walker.state().load_factor : 0;
  const std::string text =
      fmt::format("{} as a mechanism at a load factor of {:.9g}{}: {} points slide, {} are open",
                  slides(path, before, moving) ? "slides" : "turns", factor,
                  is_free ? "" : ", within 0.1 % of which it has stayed", moving.slide, moving.open);
  if (sets_out(path, load)) {
    path.memory.is_mechanism = true;
    path.report("mechanism", text);
    point.landed.emplace_back("mechanism");
  }
  if (path.ending.kind != Ending::Kind::running || path.parameters.stop.after_steps > 0) return;
  const std::vector<Landing> goals = present_goals(path);
  if (!goals.empty() && !goes_on_beside(path, goals)) return;
  if (has_locked(path, load) || !is_free_beyond(path)) return;
  if (goals.empty())
    path.end_with_structure(text);
  else
    path.stop_early(Stop::mechanism, text + "; what is wanted of the gauges comes no nearer by it");
}

}  // namespace dda
