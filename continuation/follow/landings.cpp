#include "continuation/follow/landings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "continuation/follow/trial.hpp"
#include "continuation/state/reach.hpp"

namespace dda {
std::vector<Landing> present_landings(const PathState& path) {
  std::vector<Landing> out = path.route.landings;
  out.insert(out.end(), path.leg().until.begin(), path.leg().until.end());
  if (path.is_last_leg() && !path.leg().unloads && path.parameters.stop.load_below > 0 &&
      path.memory.peak_load > 0)
    out.push_back(
        {"load", path.load,
         (path.memory.direction < 0 ? -1 : 1) * path.parameters.stop.load_below * path.memory.peak_load, true,
         true});
  return out;
}

std::vector<Landing> present_goals(const PathState& path) {
  std::vector<Landing> out = present_landings(path);
  std::erase_if(out, [](const Landing& landing) { return !landing.ends_leg || landing.only_falling; });
  return out;
}

namespace {

/// Whether the path stands on a landing's value and sets out from it: by the measure of `reached`, or by rounding of the
/// step alone, which may lead far beyond.
bool stands_on(const PathState& path, const Landing& landing, double step) {
  constexpr double rounding = 1e-12;
  const Travel& travel = path.memory.travels.at(landing.name);
  const double scale = std::max(std::abs(landing.value), std::abs(travel.farthest - travel.from));
  return std::abs(path.walker.value(landing.gauge) - landing.value) <=
         std::max(same_value * scale, rounding * std::abs(step));
}

}  // namespace

std::optional<Crossing> first_crossing(const PathState& path, const Candidate& candidate) {
  std::optional<Crossing> first;
  for (const Landing& landing : present_landings(path)) {
    const double from = path.walker.value(landing.gauge);
    const double to = candidate.state.value(landing.gauge);
    if (stands_on(path, landing, to - from)) continue;
    if ((from - landing.value) * (to - landing.value) > 0) continue;
    if (landing.only_falling && std::abs(to) > std::abs(from)) continue;
    const double share = (landing.value - from) / (to - from);
    if (!first || share < first->share) first = Crossing{landing, share};
  }
  return first;
}

std::optional<Point> land(PathState& path, const Candidate& beyond, const Crossing& crossing, StepKind kind) {
  const Landing& landing = crossing.landing;
  const double step = landing.value - path.walker.value(landing.gauge);
  const auto equation = make_gauge_equation(landing.gauge);
  const std::string place = fmt::format("{}={:g}", landing.name, landing.value);
  const std::string attempted = fmt::format("{}, landing on {}", to_string(kind), place);
  auto candidate = judged(
      path, path.walker.attempt(*equation, step, between(path.walker.state(), beyond.state, crossing.share)),
      attempted);
  if (!candidate) return {};
  constexpr double round_off = 1e-9;
  if (candidate->dissipated > beyond.dissipated * (1 + round_off)) {
    path.reject(attempted, "more energy is dissipated than beyond it");
    return {};
  }
  Point point = keep(path, *std::move(candidate), kind);
  point.landed.push_back(place);
  return point;
}

std::optional<Point> land_ahead(PathState& path, double amount, std::optional<double> most) {
  Candidate predicted = path.walker.here();
  predicted.state = path.walker.ahead(amount);
  predicted.dissipated = most.value_or(predicted.dissipated);
  const auto crossing = first_crossing(path, predicted);
  return crossing ? land(path, predicted, *crossing, StepKind::event) : std::nullopt;
}

double amount_to_landing(const PathState& path) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Landing& landing : present_landings(path)) {
    const double rate = path.walker.leaving().rate(landing.gauge);
    const double amount = (landing.value - path.walker.value(landing.gauge)) / rate;
    if (landing.only_falling || stands_on(path, landing, 0)) continue;
    if (amount > 0) nearest = std::min(nearest, amount);
  }
  return nearest;
}

std::optional<Point> land_on_next(PathState& path) {
  constexpr double beyond = 1.001;
  const double amount = amount_to_landing(path);
  if (!std::isfinite(amount)) return {};
  return land_ahead(path, beyond * amount, std::numeric_limits<double>::infinity());
}

double share_to_strength(const PathState& path, const Candidate& candidate) {
  const System& system = path.walker.system();
  const State &from = path.walker.state(), &to = candidate.state;
  const auto before = system.laws(from), after = system.laws(to);
  constexpr double round_off = 1e-10;
  double share = 1;
  for (std::size_t p = 0; p < before.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (!is_awaited(point)) continue;
    const LawAt law{*point.law, system.history()[p], point.stiffness};
    share = std::min(share, share_to_kappa(law, before.opening[p], after.opening[p], round_off));
  }
  return share;
}

std::optional<Candidate> at_strength(PathState& path, const Candidate& beyond, StepKind kind) {
  const double share = share_to_strength(path, beyond);
  const auto equation = make_event_equation(path.walker.system(), Initiation::awaited);
  return judged(path, path.walker.attempt(*equation, 1, between(path.walker.state(), beyond.state, share)),
                to_string(kind) + ", landing on a strength");
}

std::optional<Point> land_on_strength(PathState& path, const Candidate& beyond, StepKind kind) {
  auto candidate = at_strength(path, beyond, kind);
  if (!candidate) return {};
  return keep(path, *std::move(candidate), kind);
}

void report_passed(const PathState& path, const State& from, const State& to) {
  for (const Landing& landing : present_landings(path)) {
    const double before = from.value(landing.gauge), after = to.value(landing.gauge);
    if ((before - landing.value) * (after - landing.value) < 0)
      path.report("passed", fmt::format("{} = {:g} is passed by a jump from {:g} to {:g}", landing.name,
                                        landing.value, before, after));
  }
}

}  // namespace dda
