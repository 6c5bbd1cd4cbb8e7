#include "continuation/follow/trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "continuation/follow/branch.hpp"
#include "continuation/follow/judge.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/state/acceptance.hpp"

namespace dda {
namespace {

/// By how much of the way from the point before to the present one what a move prescribes grows by s again;
/// nothing where that way is too short beside it to tell a direction, or leads back.
std::optional<double> share_of_way(const PathState& path, const Move& move, double s) {
  const auto sum = move.equation->as_sum(0);
  if (!sum || !path.memory.before) return {};
  double grown = sum->spends ? path.walker.here().dissipated - path.memory.dissipated_before : 0;
  if (sum->gauge) grown += path.walker.value(*sum->gauge) - path.memory.before->value(*sum->gauge);
  const double share = s / grown;
  constexpr double longest = 10;
  return share > 0 && share <= longest ? std::optional(share) : std::nullopt;
}

/// Where Newton's method begins to look for the end of a step.
State predicted(const PathState& path, const Move& move, double amount) {
  const Predictor predictor = move.to_event ? Predictor::tangent : path.parameters.step.predictor;
  if (predictor == Predictor::constant) return path.walker.state();
  if (predictor == Predictor::secant)
    if (const auto share = share_of_way(path, move, amount * move.rate))
      return between(*path.memory.before, path.walker.state(), 1 + *share);
  return path.walker.ahead(amount);
}

Attempt attempt(PathState& path, const Move& move, double amount, Thoroughness thoroughness) {
  return path.walker.attempt(*move.equation, move.to_event ? 1.0 : amount * move.rate,
                             predicted(path, move, amount), thoroughness);
}

/// Whether the load has gone back on the way to an event although nothing cracks.
bool lies_behind(const PathState& path, const Candidate& candidate, const Move& move) {
  constexpr double round_off = 1e-9;
  const double ahead = candidate.state.load_factor - path.walker.state().load_factor;
  const double rate = path.walker.leaving().load_factor;
  return move.to_event && !path.walker.leaving().dissipates &&
         ahead * rate < -round_off * std::abs(path.walker.state().load_factor * rate);
}

}  // namespace

State between(const State& a, const State& b, double share) {
  State out = a;
  out.d = a.d.combined(1 - share, share, b.d);
  out.load_factor += share * (b.load_factor - a.load_factor);
  for (std::size_t p = 0; p < out.multipliers.size(); ++p)
    out.multipliers[p] += share * (b.multipliers[p] - a.multipliers[p]);
  return out;
}

std::optional<Candidate> try_step(PathState& path, const Move& move, double amount,
                                  Thoroughness thoroughness) {
  auto candidate = judged(path, attempt(path, move, amount, thoroughness), to_string(move.kind));
  if (!candidate || !lies_behind(path, *candidate, move)) return candidate;
  path.reject(to_string(move.kind), "the event lies behind, where cracks close");
  return {};
}

std::optional<Candidate> judged(PathState& path, const Attempt& tried, const std::string& control) {
  std::string why = tried.reason;
  path.is_refused_beside_load = false;
  if (tried.converged) {
    Candidate candidate = path.walker.evaluate(tried);
    const Objection objection = objection_to(path, candidate);
    why = objection.why;
    if (why.empty()) return candidate;
    if (objection.unsound) path.unsound = {*objection.unsound, why};
    path.is_refused_beside_load = objection.is_beside_load;
  }
  path.reject(control, why);
  return {};
}

bool refuse_jump(PathState& path, const Candidate& candidate, const std::string& control) {
  const std::string why = jump_of(path, candidate);
  if (!why.empty()) path.reject(control, why);
  return !why.empty();
}

namespace {

/// What growing cracks spend on the way to a candidate, all of it where one has grown through blocks [FL].
double cracking_energy(const Walker& walker, const Candidate& candidate) {
  const double spent = candidate.dissipated - walker.here().dissipated;
  const Equilibrium& equilibrium = walker.system().equilibrium();
  const std::vector<History>&before = walker.system().history(), &after = candidate.history;
  if (after.size() != before.size() || !(spent > 0)) return std::max(0.0, spent);
  double sum = 0;
  for (std::size_t p = 0; p < after.size(); ++p) {
    if (after[p].dissipated <= before[p].dissipated) continue;
    const InterfacePoint& point = equilibrium.point(p);
    if (point.law->damage(after[p], point.stiffness) > point.law->damage(before[p], point.stiffness))
      sum += point.weight * (after[p].dissipated - before[p].dissipated);
  }
  return sum;
}

/// The point that a candidate is to be, and what the path remembers of its load and displacement.
Point noted(PathState& path, const Candidate& candidate, StepKind kind) {
  Point out;
  out.kind = kind;
  path.memory.releases = kind == StepKind::release;
  out.newton_iterations = candidate.newton_iterations;
  out.residual = candidate.residual;
  out.multiplier_iterations = candidate.multiplier_iterations;
  out.gap = candidate.gap;
  const double load = candidate.state.value(path.load);
  path.memory.largest_force =
      std::max(path.memory.largest_force, load_on(path.walker.system(), candidate.state));
  const bool is_loaded = std::abs(load) > path.smallest_load();
  const double change = load - path.walker.state().value(path.load);
  constexpr double hardly = 1e-6;  // of the load: rounding of springs that drive under a thrust
  const bool is_told =
      is_loaded && std::abs(change) > std::max(path.smallest_load(), hardly * std::abs(load));
  if (path.memory.direction == 0 && is_told && kind != StepKind::growth)
    path.memory.direction = change > 0 ? 1 : -1;
  path.memory.cracked_since_peak += cracking_energy(path.walker, candidate);
  constexpr double same = 1e-9;  // the first point of a plateau is the highest, whatever rounding adds
  if (const double here = path.load_of(candidate.state);
      is_loaded && here > (1 + same) * path.memory.peak_load) {
    path.memory.peak_load = here;
    path.memory.cracked_to_peak += std::exchange(path.memory.cracked_since_peak, 0);
    out.is_highest = true;
  }
  constexpr double none = 1e-12;  // of the size, as of what is symmetric before a load from the side
  if (const double moved = std::abs(path.displacement_of(candidate.state)); moved > none * path.size)
    path.memory.largest_displacement = std::max(path.memory.largest_displacement, moved);
  Balance& balance = path.memory.balance;
  balance.work += candidate.work - path.walker.here().work;
  balance.largest_work = std::max(balance.largest_work, std::abs(balance.work));
  path.memory.farthest_way = std::max(path.memory.farthest_way, way_of_leg(path, candidate.state));
  path.memory.load_before = path.load_of(path.walker.state());
  return out;
}

/// The point at which the walker has arrived.
Point arrived(PathState& path, Point point) {
  point.step = path.walker.effort().accepted;
  judge_stability(path, point);
  choose_branch(path, point);
  path.memory.surplus = path.walker.here().surplus().value_or(0);
  return point;
}

}  // namespace

Point keep(PathState& path, Candidate candidate, StepKind kind) {
  Point out = noted(path, candidate, kind);
  path.memory.balance.unaccounted += std::abs(missing_work(path, candidate));
  path.memory.balance.imbalance += missing_work(path, candidate);
  if (const double quantum = candidate.dissipated - path.walker.here().dissipated; quantum > 0)
    path.memory.last_quantum = quantum;
  if (path.parameters.step.predictor == Predictor::secant) {
    path.memory.before = path.walker.state();
    path.memory.dissipated_before = path.walker.here().dissipated;
  }
  path.walker.accept(std::move(candidate));
  const bool is_under_none = path.parameters.load_gauge.empty() &&
                             std::abs(path.walker.state().value(path.load)) <= path.smallest_load();
  if (kind == StepKind::event && is_under_none) path.walker.set_out();
  return arrived(path, std::move(out));
}

std::optional<Point> jump_to(PathState& path, Candidate beyond, StepKind kind, double bearable) {
  const std::string& label = to_string(kind);
  if (!(beyond.residual <= path.parameters.newton.tolerance)) {
    path.report("rejected", fmt::format("{}: relative residual {:.1e}", label, beyond.residual));
    return {};
  }
  if (!(beyond.gap <= path.parameters.multipliers.tolerance)) {
    path.report("rejected", fmt::format("{}: relative gap {:.1e}", label, beyond.gap));
    return {};
  }
  if (creates_energy(path, beyond, kind, bearable)) {
    path.refusal = "the jump would create energy";
    path.report("rejected", label + ": " + path.refusal);
    return {};
  }
  if (const auto refused = unsoundness(path, beyond)) {
    path.unsound = refused;
    path.report("rejected", fmt::format("{}: {}", label, refused->text));
    return {};
  }
  if (!beyond.solution && !path.walker.confirm(beyond)) {
    path.report("rejected", label + ": NOX does not converge there");
    return {};
  }
  report_passed(path, path.walker.state(), beyond.state);
  Point point = noted(path, beyond, kind);
  point.jump_energy = path.walker.jump(std::move(beyond));
  path.memory.jump_energy += point.jump_energy;
  path.memory.step = 0;
  path.memory.before.reset();
  return arrived(path, std::move(point));
}

}  // namespace dda
