#include "studies/dda/run/next_point.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dda {
namespace {

bool is_finite(const Candidate& at) {
  return std::ranges::all_of(std::array{at.state.load_factor, at.load, at.stored, at.dissipated, at.work},
                             [](double x) { return std::isfinite(x); });
}

/// Ends to which joints that lock may have led.
bool leads_nowhere(Stop stop) {
  constexpr std::array ends{Stop::dynamic,  Stop::limit_of_steps,  Stop::standstill,
                            Stop::singular, Stop::next_initiation, Stop::no_next_equilibrium};
  return std::ranges::find(ends, stop) != ends.end();
}

}  // namespace

std::optional<Point> next_point(Simulation& simulation, RunRecorder* recorder, Ending& ending) {
  const auto scope = simulation.system().timings().measure("path");
  auto point = simulation.path().next();
  if (!point) {
    ending = simulation.path().ending();
    if (ending.stop && leads_nowhere(*ending.stop)) ending.reason += simulation.hindrance();
    return {};
  }
  if (!is_finite(simulation.walker().here())) {
    ending = {Ending::Kind::stopped_early,
              "the numbers of the next step are too large or too small to compute with", Stop::out_of_range};
    return {};
  }
  if (recorder) recorder->record(*point);
  return point;
}

}  // namespace dda
