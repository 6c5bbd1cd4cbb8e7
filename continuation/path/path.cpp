#include "continuation/path/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "continuation/state/acceptance.hpp"
#include "continuation/walk/energy.hpp"

namespace dda {
namespace {

/// The path's load gauge: the deck's by name, else the stage's own.
Functional find_load(const std::string& name, const GaugeBook& book, const Functional& fallback,
                     const Position& where) {
  if (name.empty()) return fallback;
  for (const NamedGauge& gauge : book.gauges)
    if (gauge.name == name) return gauge.functional;
  throw InputError(where, "`load_gauge` names '" + name + "', which is not among the gauges");
}

}  // namespace

Path::Path(Walker& walker, const PathParameters& parameters, const GaugeBook& gauges,
           std::vector<Landing> landings, std::vector<Leg> legs)
    : walker_(walker),
      parameters_(parameters),
      control_(parameters.control.make(gauges)),
      load_(find_load(parameters.load_gauge, gauges, walker.system().loading().load, parameters.where)),
      displacement_(displacement_of_load(walker.system().loading())),
      landings_(std::move(landings)),
      legs_(std::move(legs)),
      travelling_(gauges.gauges),
      size_(size_of(walker.system().equilibrium())),
      standstill_(walker.system().equilibrium().block_size(), size_) {
  if (std::ranges::find(travelling_, "load", &NamedGauge::name) == travelling_.end())
    travelling_.push_back({"load", walker.system().loading().load, dimension::force});
  for (const auto& law : walker.system().equilibrium().interfaces().laws)
    releases_at_once_ = releases_at_once_ || law->releases_at_once();
  memory_.largest_force = holding_of(walker_.system(), walker_.state()).load;
  set_out();
}

PathMemory Path::memory() const {
  PathMemory out = memory_;
  out.control = control_->memory();
  return out;
}

void Path::restore(const PathMemory& memory) {
  auto here = std::move(memory_.travels);
  memory_ = memory;
  memory_.travels.merge(here);  // gauges that the deck did not have before
  control_->restore(memory.control);
}

double Path::load_of(const State& state) const {
  return (memory_.direction < 0 ? -1 : 1) * load_.value(state.d, state.load_factor);
}

/// A load below this is none: the tolerances of the equilibria leave as much of the other forces.
double Path::smallest_load() const {
  constexpr double margin = 10;
  if (!parameters_.load_gauge.empty()) return 0;
  const StepperParameters& kept = walker_.parameters();
  const double gap = walker_.system().iterates_multipliers() ? kept.multipliers.tolerance : 0;
  return margin * (kept.newton.tolerance + gap) * memory_.largest_force;
}

double Path::displacement_of(const State& state) const {
  return displacement_.value(state.d, state.load_factor);
}

double Path::displacement_rate(const Tangent& tangent) const { return tangent.rate(displacement_); }

std::optional<Point> Path::end(Ending::Kind kind, std::string reason) {
  if (kind == Ending::Kind::stopped_early && !unsound_.empty()) return end_of_sound(std::move(reason));
  ending_ = {kind, std::move(reason)};
  return {};
}

std::optional<Point> Path::next() {
  settle();
  if (ending_.kind != Ending::Kind::running) return {};
  if (interrupted_ && interrupted_()) return end(Ending::Kind::interrupted, "interrupted");
  if (walker_.effort().accepted >= parameters_.stop.steps)
    return end(Ending::Kind::stopped_early,
               fmt::format("the limit of {} steps is reached; `path.stop.steps` raises it, "
                           "`path.stop.after_steps` makes a number of steps the goal",
                           parameters_.stop.steps));
  unsound_.clear();
  auto point = take_step();
  unsound_.clear();
  if (!point) return {};
  note_travel();
  settle();
  look_for_standstill(*point);
  return point;
}

Point Path::keep(Candidate candidate, const std::string& control) {
  Point out;
  out.control = control;
  out.newton_iterations = candidate.newton_iterations;
  out.residual = candidate.residual;
  out.multiplier_iterations = candidate.multiplier_iterations;
  out.gap = candidate.gap;
  const double load = load_.value(candidate.state.d, candidate.state.load_factor);
  memory_.largest_force = std::max(memory_.largest_force, holding_of(walker_.system(), candidate.state).load);
  const bool is_loaded = std::abs(load) > smallest_load();
  if (memory_.direction == 0 && is_loaded) memory_.direction = load > 0 ? 1 : -1;
  constexpr double same = 1e-9;  // the first point of a plateau is the highest, whatever rounding adds
  if (const double here = load_of(candidate.state); is_loaded && here > (1 + same) * memory_.peak_load) {
    memory_.peak_load = here;
    out.is_highest = true;
  }
  memory_.unaccounted += std::abs(missing_work(candidate));
  memory_.imbalance += missing_work(candidate);
  memory_.largest_displacement =
      std::max(memory_.largest_displacement, std::abs(displacement_of(candidate.state)));
  if (const double quantum = candidate.dissipated - walker_.here().dissipated; quantum > 0)
    memory_.last_quantum = quantum;
  walker_.accept(std::move(candidate));
  out.step = walker_.effort().accepted;
  judge(out);
  choose_branch(out);
  memory_.surplus = walker_.here().surplus().value_or(0);
  return out;
}

}  // namespace dda
