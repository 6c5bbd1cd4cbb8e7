#include "continuation/course/path_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/state/acceptance.hpp"
#include "continuation/walk/energy.hpp"

namespace dda {
namespace {

/// The path's load gauge: the deck's by name, else the stage's own.
Functional find_load(const PathParameters& parameters, const GaugeBook& book, const Functional& fallback) {
  const std::string& name = parameters.load_gauge;
  if (name.empty()) return fallback;
  for (const NamedGauge& gauge : book.gauges)
    if (gauge.name == name) return gauge.functional;
  throw InputError(parameters.where, "`load_gauge` names '" + name + "', which is not among the gauges");
}

/// As the deck says; else so many that each point that loses its strength at once may take some of its own.
int most_steps_of(const StopRules& stop, const Equilibrium& equilibrium) {
  constexpr int usual = 1000, for_each = 20;
  if (stop.steps) return *stop.steps;
  int out = usual;
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p)
    if (equilibrium.point(p).law->releases_at_once()) out += for_each;
  return out;
}

}  // namespace

PathState::PathState(Walker& stands, const PathParameters& wanted, const GaugeBook& gauges, Route way)
    : walker(stands), parameters(wanted), size(walker.system().equilibrium().extent()) {
  memory.standstill = Standstill(size);
  look_up({gauges, std::move(way)});
  for (const auto& law : walker.system().equilibrium().interfaces().laws)
    releases_at_once = releases_at_once || law->releases_at_once();
  most_steps = most_steps_of(parameters.stop, walker.system().equilibrium());
  memory.largest_force = load_on(walker.system(), walker.state());
}

void PathState::look_up(const Aims& aims) {
  const Loading& loading = walker.system().loading();
  auto made = parameters.control.make(aims.gauges);
  if (control) made->restore(control->memory());
  control = std::move(made);
  load = find_load(parameters, aims.gauges, loading.load);
  const double at_once = loading.load_is_force ? 1 : walker.system().residual_norm(loading.reference);
  load_per_force = at_once > 0 ? 1 / at_once : 0;
  displacement = displacement_of_load(loading, walker.system().equilibrium().num_blocks());
  route = aims.route;
  travelling = aims.gauges.gauges;
  if (std::ranges::find(travelling, "load", &NamedGauge::name) == travelling.end())
    travelling.push_back({"load", loading.load, dimension::force});
  const auto add = [&](const Landing& landing) {
    if (std::ranges::find(travelling, landing.name, &NamedGauge::name) == travelling.end())
      travelling.push_back({landing.name, landing.gauge, {}});
  };
  std::ranges::for_each(route.landings, add);
  for (const Leg& leg : route.legs) std::ranges::for_each(leg.until, add);
}

double PathState::load_of(const State& state) const {
  return (memory.direction < 0 ? -1 : 1) * state.value(load);
}

double PathState::smallest_load() const {
  constexpr double margin = 10;
  if (!parameters.load_gauge.empty()) return 0;
  const StepperParameters& kept = walker.parameters();
  const double gap = walker.system().iterates_multipliers() ? kept.multipliers.tolerance : 0;
  return as_load(margin * (kept.newton.tolerance + gap) * memory.largest_force);
}

double PathState::displacement_of(const State& state) const { return state.value(displacement); }

double PathState::share_of_peak() const {
  if (!(memory.peak_load > smallest_load())) return 1;
  return std::abs(load_of(walker.state())) / memory.peak_load;
}

double PathState::displacement_rate(const Tangent& tangent) const { return tangent.rate(displacement); }

std::optional<Point> PathState::end(Ending::Kind kind, std::string reason) {
  ending = {kind, std::move(reason)};
  return {};
}

std::optional<Point> PathState::stop_early(Stop stop, std::string reason) {
  if (unsound)
    end_unsound(reason);
  else
    ending = {Ending::Kind::stopped_early, std::move(reason), stop};
  return {};
}

std::optional<Point> PathState::end_with_structure(std::string reason) {
  if (is_last_leg()) return end(Ending::Kind::goal_reached, std::move(reason));
  std::vector<std::string> names;
  for (auto next = static_cast<std::size_t>(memory.leg) + 1; next < route.legs.size(); ++next)
    names.push_back("'" + route.legs[next].name + "'");
  return stop_early(Stop::stages_left,
                    fmt::format("{}; not followed any more: {}", reason, fmt::join(names, ", ")));
}

/// The end where every equilibrium that was found is unsound: of a path that is followed to rupture its goal,
/// when hardly any load is left.
void PathState::end_unsound(const std::string& reason) {
  const Stopped refused = *std::exchange(unsound, {});
  constexpr double hardly_any = 0.01;
  const double left = share_of_peak();
  if (parameters.stop.load_below == 0 && walker.here().dissipated > 0 && left < hardly_any)
    end_with_structure(
        fmt::format("complete rupture: {:.1e} of the peak was left; beyond, {}", left, refused.text));
  else
    ending = {Ending::Kind::stopped_early,  // which the last try may have told already
              reason.find(refused.text) != std::string::npos ? reason
                                                             : fmt::format("{} ({})", refused.text, reason),
              refused.stop};
}

void PathState::reject(const std::string& control_name, const std::string& why) {
  refusal = why;
  ++walker.effort().rejected;
  report("rejected", fmt::format("{}: {}", control_name, why));
}

}  // namespace dda
