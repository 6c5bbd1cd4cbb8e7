// Steps that no control leads along: sequentially linear rescue, instantaneous release, load increments.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "continuation/detour/increment/load_increment.hpp"
#include "continuation/detour/release.hpp"
#include "continuation/detour/rescue.hpp"
#include "continuation/path/path.hpp"

namespace dda {
namespace {

/// A release is tried again with this share of its length when no continuous path leads so far.
constexpr double cut = 0.25;

/// |R·Δd| + Σ W |t·Δm|, R and the gaps P⁻¹ t − m of a state with its history: by so much its energies may be
/// off those of the equilibrium which it is within the tolerances.
double tolerated_work(System& system, const Candidate& at, const std::vector<double>& along) {
  const std::vector<History> history = system.history();
  const std::vector<Vec2> multipliers = system.multipliers();
  system.set_history(at.history);
  system.set_multipliers(at.state.multipliers);
  const auto laws = system.laws_at(at.state.d, at.state.load_factor);
  std::vector<double> r(along.size());
  system.residual(at.state.d, at.state.load_factor, *laws, r);
  double work = std::abs(std::inner_product(r.begin(), r.end(), along.begin(), 0.0));
  const std::vector<Vec2> next = system.next_multipliers(*laws);
  for (std::size_t p = 0; p < next.size(); ++p)
    work += system.equilibrium().point(p).weight *
            std::abs(laws->traction[p].dot(next[p] - at.state.multipliers[p]));
  system.set_history(history);
  system.set_multipliers(multipliers);
  return work;
}

}  // namespace

std::optional<Point> Path::sequential_step(const std::string& control, double quantum) {
  const auto found = sequentially_linear(walker_.system(), walker_.state(), quantum);
  if (!found || is_mechanism(found->state)) return {};
  const double dissipated = walker_.here().dissipated;
  auto point = jump_to(walker_.settled(*found), control);
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
  return created > explained + tolerated_work(system, beyond, along) + tolerated_work(system, here, along);
}

/// Accepts an equilibrium that no control led to; a wanted value can be passed but not landed on.
std::optional<Point> Path::jump_to(Candidate beyond, const std::string& control) {
  if (!(beyond.residual <= parameters_.newton.tolerance)) {
    report("rejected", fmt::format("{}: relative residual {:.1e}", control, beyond.residual));
    return {};
  }
  if (!(beyond.gap <= parameters_.multipliers.tolerance)) {
    report("rejected", fmt::format("{}: relative gap {:.1e}", control, beyond.gap));
    return {};
  }
  if (creates_energy(beyond)) {
    report("rejected", control + ": the jump would create energy");
    return {};
  }
  if (const std::string why = unsoundness(beyond); !why.empty()) {
    report("rejected", fmt::format("{}: {}", control, why));
    return {};
  }
  report_passed(walker_.state(), beyond.state);
  const double released = walker_.jump(std::move(beyond));
  memory_.jump_energy += released;
  memory_.step = 0;
  Candidate here = walker_.here();
  --walker_.effort().accepted;
  Point point = keep(std::move(here), control);
  point.jump_energy = released;
  return point;
}

/// Whether a release has turned the load round while contacts changed: an equilibrium that it does not lead
/// to. A straight piece may do so.
bool Path::turns_load_round(const ReleasedPiece& piece) const {
  constexpr double hardly = -0.1;  // what is held by friction after unloading
  const double before = walker_.state().load_factor;
  return !piece.is_straight && before != 0 && piece.end.state.load_factor / before < hardly;
}

/// Next vertex of an instantaneous release; where no continuous path leads on, what a test would find after a
/// jump.
std::optional<Point> Path::release_step() {
  const auto held = control_->held_in_release();
  if (auto point = release_holding(held ? &*held : nullptr)) return point;
  if (!control_->may_be_rescued())
    return end(Ending::Kind::stopped_early,
               held ? "failure: what is released leaves no equilibrium under this control; use `staged`"
                    : "what is released leaves no equilibrium");
  return release_by_jump();
}

/// The farthest vertex, of some, to which a release leads. Where contacts change on the way the path is not
/// straight, and its end is told from another equilibrium by going less far.
std::optional<Point> Path::release_holding(const Functional* held) {
  constexpr double nearest = 0.05, of_spent = 0.1, of_work = 1e-3;
  const Candidate& here = walker_.here();
  for (double most = 1; most > nearest; most *= cut) {
    const auto found = release_piece(walker_.system(), walker_.state(), parameters_, held, most);
    if (!found || is_mechanism(found->end.state) || turns_load_round(*found)) continue;
    Candidate beyond = walker_.settled(found->end);
    const double spent = std::abs(beyond.dissipated - here.dissipated),
                 work = std::abs(beyond.work - here.work);
    const bool is_straight = !loses_work(beyond, of_spent * spent + of_work * work);
    if (!is_straight && most * cut > nearest) continue;
    if (const auto crossing = first_crossing(beyond))
      if (auto point = release_up_to(*crossing, held, most)) return point;
    if (auto point = jump_to(std::move(beyond), "release")) return point;
  }
  return {};
}

/// A release only as far as a straight one takes a gauge to a wanted value.
std::optional<Point> Path::release_up_to(const Crossing& crossing, const Functional* held, double most) {
  const Landing& landing = crossing.landing;
  const double share = crossing.share * most;
  const auto found = release_piece(walker_.system(), walker_.state(), parameters_, held, share);
  if (!found) return {};
  const State& at = found->end.state;
  const double off = std::abs(landing.gauge.value(at.d, at.load_factor) - landing.value);
  if (off > same_value * std::abs(landing.value - walker_.value(landing.gauge))) return {};
  auto point = jump_to(walker_.settled(found->end), "release");
  if (point) point->landed.push_back(fmt::format("{}={:g}", landing.name, landing.value));
  return point;
}

/// What a test finds that prescribes the displacement on which the load works: the pending points lose their
/// strength while it is held, together or at last at once; else the largest of some shares of the load.
std::optional<Point> Path::release_by_jump() {
  System& system = walker_.system();
  const State start = walker_.state();
  const auto accepted = [&](const std::optional<Settled>& found) {
    if (!found || is_mechanism(found->state)) return std::optional<Point>();
    return jump_to(walker_.settled(*found), "release");
  };
  std::optional<Point> point;
  const auto piece = release_piece(system, start, parameters_, &displacement_, 1);
  if (piece) point = accepted(piece->end);
  if (!point)
    point = accepted(release_at_gauge(system, start, parameters_, displacement_, displacement_of(start)));
  for (const double share : {1.0, 0.9, 0.75, 0.5, 0.25, 0.1})
    if (!point) point = accepted(release_at_load(system, start, parameters_, share * start.load_factor));
  if (!point) return end_without_equilibrium("what is released leaves no equilibrium");
  ++walker_.effort().rescues;
  report("rescued", fmt::format("the release jumped from a load factor of {:g} to {:g}", start.load_factor,
                                walker_.state().load_factor));
  return point;
}

/// The largest of some steps of the displacement on which the load works that ends in an equilibrium, what is
/// beyond its strength there released at once: a path through contacts that change is not found by its
/// tangent.
std::optional<Point> Path::driven_step() {
  constexpr double largest = 0.02, smallest = 1e-4;  // of the displacement so far
  if (memory_.largest_displacement == 0) return {};
  const State& start = walker_.state();
  const double here = displacement_of(start);
  for (double share = largest; share > smallest; share *= cut) {
    const double value = here + std::copysign(share * memory_.largest_displacement, here);
    const auto found = release_at_gauge(walker_.system(), start, parameters_, displacement_, value);
    if (!found || is_mechanism(found->state)) continue;
    auto point = jump_to(walker_.settled(*found), "displacement");
    if (!point) continue;
    ++walker_.effort().rescues;
    report("rescued", fmt::format("the displacement of the load was raised by {:.1e} of its largest", share));
    return point;
  }
  return {};
}

/// The end where nothing is found any more: rupture if hardly any load is left.
std::optional<Point> Path::end_without_equilibrium(const std::string& why) {
  constexpr double hardly_any = 0.01;
  const double left = std::abs(load_of(walker_.state())) / memory_.peak_load;
  if (left < hardly_any)
    return end(Ending::Kind::goal_reached,
               fmt::format("complete rupture: {:.1e} of the peak was left", left));
  return end(Ending::Kind::stopped_early, why);
}

/// The load raised by the largest of halved increments that still finds an equilibrium.
std::optional<Point> Path::increment_step() {
  if (memory_.step == 0) memory_.step = control_->load_increment() * next_event(walker_);
  if (!std::isfinite(memory_.step)) return linear_step();
  constexpr double smallest_share = 1e-4;
  const double first = memory_.step;
  const double smallest = smallest_share * std::max(first, std::abs(walker_.state().load_factor));
  std::string why = fmt::format("the increments have fallen below {:g} of it", smallest_share);
  for (double increment = first; increment > smallest; increment *= 0.5) {
    const Increment found =
        load_increment(walker_.system(), walker_.state(), {increment, *control_->load_solver()}, parameters_);
    walker_.effort().newton_iterations += found.newton_iterations;
    walker_.effort().relaxation_iterations += found.relaxation_iterations;
    if (!found.settled || is_mechanism(found.settled->state)) {
      why = found.settled ? "what is left is a mechanism" : found.why;
      reject("load_increments", why);
      continue;
    }
    auto point = jump_to(walker_.settled(*found.settled), "load_increments");
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
