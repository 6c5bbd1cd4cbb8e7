#include "continuation/follow/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "continuation/follow/mechanism.hpp"
#include "continuation/state/acceptance.hpp"
#include "continuation/state/history_guard.hpp"

namespace dda {
namespace {

/// A step is tried again with this share of its size when Newton fails.
constexpr double cut = 0.25;

/// |R·Δd| + Σ W |t·Δm|, R and the gaps P⁻¹ t − m of a state with its history: by so much its energies may be
/// off those of the equilibrium which it is within the tolerances.
double tolerated_work(System& system, const Candidate& at, const std::vector<double>& along) {
  const HistoryGuard back(system);
  system.set_history(at.history);
  system.set_multipliers(at.state.multipliers);
  const auto laws = system.laws_at(at.state);
  std::vector<double> r(along.size());
  system.residual(at.state.d, at.state.load_factor, *laws, r);
  double work = std::abs(std::inner_product(r.begin(), r.end(), along.begin(), 0.0));
  const std::vector<Vec2> next = system.next_multipliers(*laws);
  for (std::size_t p = 0; p < next.size(); ++p)
    work += system.equilibrium().point(p).weight *
            std::abs(laws->traction[p].dot(next[p] - at.state.multipliers[p]));
  return work;
}

/// Why the sum of what the steps leave unaccounted for is too much with this one, beside the most that loads have done; ""
/// when it is not.
std::string energy_objection(const PathState& path, const Candidate& candidate) {
  const double missing = std::abs(path.memory.balance.imbalance + missing_work(path, candidate));
  // Of an unloaded end the rounding of the other may be all there is.
  double energy = path.memory.balance.largest_work;
  for (const Candidate* at : {&path.walker.here(), &candidate})
    energy = std::max({energy, std::abs(at->work), std::abs(at->stored), std::abs(at->dissipated)});
  if (missing <= path.parameters.stop.energy_error * energy) return {};
  return fmt::format(
      "the energies do not balance: {:.1e} of the work is unaccounted for (at most "
      "`path.stop.energy_error`); try a smaller `path.step.accuracy`",
      missing / energy);
}

}  // namespace

double missing_work(const PathState& path, const Candidate& candidate) {
  const Candidate& here = path.walker.here();
  return (candidate.work - here.work) - (candidate.stored - here.stored) -
         (candidate.dissipated - here.dissipated);
}

bool loses_work(const PathState& path, const Candidate& candidate, double most) {
  const double missing = std::abs(missing_work(path, candidate));
  return missing > most &&
         missing - path.walker.system().rounding_of_work(path.walker.state(), candidate.state) > most;
}

bool only_touches(const PathState& path, const Candidate& candidate) {
  return !path.walker.leaving().dissipates && !candidate.arriving.dissipates && can_slide(path);
}

bool is_coarse(const PathState& path, const Candidate& candidate) {
  constexpr double share = 0.01;  // of the accuracy, twice what the step size aims at
  const double of_sliding = path.walker.system().joins_by_contact() ? 0.02 : 0.01;
  const double work = std::abs(candidate.work - path.walker.here().work);
  const double fine = share * path.parameters.step.accuracy;
  if (!only_touches(path, candidate)) return loses_work(path, candidate, fine * std::abs(candidate.work));
  const double of_live = std::abs(path.load_of(candidate.state) * path.displacement_of(candidate.state));
  const double moved = path.displacement_of(candidate.state) - path.displacement_of(path.walker.state());
  const double of_none = path.smallest_load() * std::abs(moved);  // what a load does that counts as none
  return loses_work(path, candidate, std::max({fine * of_live, of_sliding * work, of_none}));
}

std::optional<Stopped> unsoundness(const PathState& path, const Candidate& candidate) {
  const System& system = path.walker.system();
  const auto of = [&](const Holding& holding) {
    return objection_to(holding, {path.size, path.memory.largest_force}, system.equilibrium());
  };
  std::string why;
  if (candidate.state.d.are_all_known() || !of(bound_of_holding(system, candidate.state)).empty())
    why = of(holding_of(system, candidate.state));
  if (!why.empty()) return Stopped{Stop::weak_springs, std::move(why)};
  why = objection_to(candidate.excess, system);
  if (!why.empty()) return Stopped{Stop::beyond_strength, std::move(why)};
  return {};
}

std::string jump_of(const PathState& path, const Candidate& candidate) {
  const Candidate& here = path.walker.here();
  const double dissipated = candidate.dissipated - here.dissipated, work = candidate.work - here.work;
  constexpr double of_dissipation = 0.1, of_total = 0.02, of_work = 0.01;
  if (!loses_work(
          path, candidate,
          of_dissipation * std::max(dissipated, of_total * candidate.dissipated) + of_work * std::abs(work)))
    return {};
  return fmt::format("the step jumps: {:.1e} of its work is unaccounted for",
                     std::abs(missing_work(path, candidate) / work));
}

Objection objection_to(const PathState& path, const Candidate& candidate) {
  if (auto refused = unsoundness(path, candidate)) return {std::move(refused->text), refused->stop};
  if (std::string why = energy_objection(path, candidate); !why.empty())
    return {std::move(why), Stop::energies};
  if (!only_touches(path, candidate))  // there it may only be long
    if (std::string why = jump_of(path, candidate); !why.empty()) return {std::move(why)};
  if (std::string why = too_far_beside_load(path, candidate); !why.empty())
    return {.why = std::move(why), .is_beside_load = true};
  const Candidate& here = path.walker.here();
  const double dissipated = candidate.dissipated - here.dissipated;
  const double before = std::abs(path.load_of(path.walker.state())),
               after = std::abs(path.load_of(candidate.state));
  if (here.dissipated > 0 && dissipated <= 0 && after < before && before > path.smallest_load() &&
      path.walker.leaving().dissipates)
    return {"the step retraces the unloading branch"};
  return {};
}

bool creates_energy(const PathState& path, const Candidate& beyond, StepKind kind, double bearable) {
  const Candidate& here = path.walker.here();
  const double spent = beyond.dissipated - here.dissipated, work = beyond.work - here.work;
  constexpr double round_off = 1e-8;
  const double of_spent = kind == StepKind::jump ? 0.25 : 0.9;
  const double created = (beyond.stored - here.stored) + spent - work;
  const double explained = of_spent * spent + round_off * std::abs(beyond.work) + bearable;
  if (created <= explained) return false;
  const std::vector<double>& from = here.state.d;
  std::vector<double> along = beyond.state.d;
  for (std::size_t i = 0; i < along.size(); ++i) along[i] -= from[i];
  System& system = path.walker.system();
  return created > explained + tolerated_work(system, beyond, along) + tolerated_work(system, here, along);
}

}  // namespace dda
