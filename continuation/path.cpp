#include "continuation/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "continuation/energy.hpp"

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
      driver_(parameters.control.make(gauges)),
      load_(find_load(parameters.load_gauge, gauges, walker.system().loading().load, parameters.where)),
      displacement_(displacement_of_load(walker.system().loading())),
      landings_(std::move(landings)),
      legs_(std::move(legs)) {
  for (const auto& law : walker.system().equilibrium().interfaces().laws)
    releases_at_once_ = releases_at_once_ || law->releases_at_once();
}

PathMemory Path::memory() const {
  PathMemory out = memory_;
  out.driver = driver_->memory();
  return out;
}

void Path::restore(const PathMemory& memory) {
  memory_ = memory;
  driver_->restore(memory.driver);
}

double Path::load_of(const State& state) const {
  return (memory_.direction < 0 ? -1 : 1) * load_.value(state.d, state.load_factor);
}

double Path::displacement_of(const State& state) const {
  return displacement_.value(state.d, state.load_factor);
}

double Path::displacement_rate(const Tangent& tangent) const { return tangent.rate(displacement_); }

std::optional<Point> Path::end(Ending::Kind kind, std::string reason) {
  ending_ = {kind, std::move(reason)};
  return {};
}

std::optional<Point> Path::next() {
  if (ending_.kind != Ending::Kind::running) return {};
  if (interrupted_ && interrupted_()) return end(Ending::Kind::interrupted, "interrupted");
  if (at_end()) return {};
  return take_step();
}

bool Path::at_end() {
  if (walker_.effort().accepted >= parameters_.stop.steps) {
    end(Ending::Kind::goal_reached, fmt::format("{} steps", parameters_.stop.steps));
    return true;
  }
  constexpr double nothing = 1e-6;
  const bool at_leg_start = memory_.leg > 0 && walker_.effort().accepted == memory_.leg_start;
  if (!leg().unloads && !at_leg_start && memory_.peak_load > 0 &&
      std::abs(load_of(walker_.state())) <= nothing * memory_.peak_load && walker_.here().dissipated > 0) {
    end(Ending::Kind::goal_reached, "complete rupture");
    return true;
  }
  return false;
}

Point Path::keep(Candidate candidate, const std::string& control) {
  Point out;
  out.control = control;
  out.newton_iterations = candidate.newton_iterations;
  out.residual = candidate.residual;
  out.multiplier_iterations = candidate.multiplier_iterations;
  out.gap = candidate.gap;
  const double load = load_.value(candidate.state.d, candidate.state.load_factor);
  if (memory_.direction == 0 && load != 0) memory_.direction = load > 0 ? 1 : -1;
  if (const double here = load_of(candidate.state); here > memory_.peak_load) {
    memory_.peak_load = here;
    out.is_highest = true;
  }
  memory_.unaccounted += unaccounted(candidate);
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
