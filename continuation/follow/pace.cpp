#include "continuation/follow/pace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/follow/judge.hpp"
#include "continuation/follow/mechanism.hpp"

namespace dda {
namespace {

/// What changes of the load are measured by: its largest so far, to either side, and where dead loads have cracked the
/// structure before there is any, a hundredth of the forces that act.
double load_size(const PathState& path) {
  constexpr double hardly = 0.01;
  const bool is_of_loads = path.parameters.load_gauge.empty();
  return std::max({path.memory.peak_load, std::abs(path.load_of(path.walker.state())),
                   is_of_loads ? path.as_load(hardly * path.memory.largest_force) : 0.0});
}

}  // namespace

Thoroughness thoroughness_of(double share) {
  constexpr double few_cuts = 0.1;
  return share <= few_cuts ? Thoroughness::full : Thoroughness::quick;
}

double first_amount(const PathState& path) {
  const Tangent& leaving = path.walker.leaving();
  if (!leaving.dissipates)
    return 0.25 *
           std::min(next_event(path.walker), std::max(1e-3, std::abs(path.walker.state().load_factor)));
  constexpr double of_load = 0.02, of_opening = 0.1, of_way = 0.25;
  const double load_rate = std::abs(leaving.rate(path.load)),
               load = std::abs(path.load_of(path.walker.state()));
  const bool is_none = load <= path.smallest_load();
  double amount = !is_none && load_rate > 0 ? of_load * load / load_rate
                  : is_none                 ? of_way * next_new_crack(path.walker)
                                            : std::numeric_limits<double>::infinity();
  const System& system = path.walker.system();
  const auto laws = system.laws(path.walker.state());
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const History& h = system.history()[p];
    if (!h.loading) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const double rate =
        point.law->opening_gradient(laws.opening[p], h, point.stiffness).dot(leaving.opening[p]);
    const double left = point.law->rupture_kappa(point.stiffness) - system.kappa(p);
    if (rate > 0 && left > 0) amount = std::min(amount, of_opening * left / rate);
  }
  return amount;
}

double first_amount(const PathState& path, const Move& move) {
  const auto& wanted = path.parameters.step.first;
  return wanted ? *wanted / std::abs(move.rate) : first_amount(path);
}

double unit_of(const PathState& path, const Move& move) {
  return path.walker.leaving().dissipates ? 1 : std::abs(move.rate);
}

double sliding_amount(const PathState& path) {
  constexpr double little = 0.001;
  const double load_rate = std::abs(path.walker.leaving().rate(path.load));
  return load_rate > 0 ? little * load_size(path) / load_rate : 0;
}

double bounded(const PathState& path, const Move& move, double amount) {
  const double load_rate = std::abs(path.walker.leaving().rate(path.load));
  const double displacement_rate_now = std::abs(path.displacement_rate(path.walker.leaving()));
  const double load_size_now = load_size(path);
  const bool only_slides = !path.walker.leaving().dissipates && can_slide(path);
  const double of_load =
      only_slides ? 1.5 : 1;  // steps of contacts alone are exact but for the order of changes
  if (load_rate > 0 && load_size_now > 0)
    amount = std::min(amount, of_load * path.parameters.step.largest * load_size_now / load_rate);
  constexpr double of_displacement = 5;  // displacement may grow by half in one step of the default size
  if (displacement_rate_now > 0 && path.memory.largest_displacement > 0)
    amount = std::min(amount, of_displacement * path.parameters.step.largest *
                                  path.memory.largest_displacement / displacement_rate_now);
  if (path.parameters.step.longest)
    amount = std::min(amount, *path.parameters.step.longest / std::abs(move.rate));
  return amount;
}

namespace {

/// By how much the next step may grow for what this one has strayed from its tangent.
double growth_by_deviation(const PathState& path, const Candidate& candidate, double amount) {
  const State predicted = path.walker.ahead(amount);
  const double load = std::abs(path.load_of(predicted) - path.load_of(candidate.state)) /
                      std::max(load_size(path), std::abs(path.load_of(candidate.state)));
  const double displacement =
      std::abs(path.displacement_of(predicted) - path.displacement_of(candidate.state)) /
      std::max(path.memory.largest_displacement, std::abs(path.displacement_of(candidate.state)));
  constexpr double balance_share = 0.005;  // of the accuracy, for the energy a step leaves unaccounted for
  const double strayed = std::max(
      {load, displacement, std::abs(missing_work(path, candidate)) / candidate.work / balance_share, 1e-12});
  return std::clamp(std::sqrt(path.parameters.step.accuracy / strayed), 0.3, 2.0);
}

/// LOCA's adaptive step size, 1 + a (1 − n/N)².
double growth_by_iterations(const PathState& path, const Candidate& candidate) {
  const double most = path.parameters.newton.most(),
               left = 1 - std::min<double>(candidate.newton_iterations, most) / most;
  return 1 + path.parameters.step.aggressiveness.value_or(0.5) * left * left;
}

}  // namespace

void resize(PathState& path, const Candidate& candidate, double amount, const Move& move) {
  const bool is_known = path.memory.step > 0 && path.memory.step_kind == move.kind;
  const double taken = amount * unit_of(path, move);
  switch (path.parameters.step.sizing) {
    case Sizing::deviation:
      path.memory.step = taken * growth_by_deviation(path, candidate, amount);
      break;
    case Sizing::iterations:
      path.memory.step = taken * growth_by_iterations(path, candidate);
      break;
    case Sizing::constant:
      if (!is_known) path.memory.step = taken;
  }
  path.memory.step_kind = move.kind;
}

}  // namespace dda
