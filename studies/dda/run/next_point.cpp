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

}  // namespace

std::optional<Point> next_point(Simulation& simulation, RunRecorder* recorder, Ending& ending) {
  const auto scope = simulation.system().timings().measure("path");
  auto point = simulation.path().next();
  if (!point) {
    ending = simulation.path().ending();
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
