#include <algorithm>
#include <cmath>

#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {
namespace {

std::string stray(const PathState& path, const Candidate& candidate, const State& ahead) {
  constexpr double far = 0.5;  // of all displacement so far, and of what a step may change the load by
  const double moved = std::abs(path.displacement_of(candidate.state) - path.displacement_of(ahead));
  const double largest = path.memory.largest_displacement;
  if (largest > 0 && moved > far * std::max(largest, std::abs(path.displacement_of(candidate.state))))
    return "the step strays from its tangent by more than half of all displacement so far";
  const double load = path.load_of(candidate.state), fallen = path.load_of(ahead) - load;
  if (path.walker.leaving().dissipates && path.memory.peak_load > 0 && load > 0 &&
      fallen > far * path.parameters.step.largest * path.memory.peak_load)
    return "the step falls off its tangent by more than half of what the load may change in one";
  return {};
}

}  // namespace

std::optional<Outcome> refuse_stray(PathState& path, const Candidate& candidate, Stride& stride) {
  const std::string why = stray(path, candidate, path.walker.ahead(stride.amount));
  if (why.empty()) return {};
  stride.why = why;
  path.reject(to_string(stride.move.kind), why);
  if (stride.cuts++ > 0)
    if (auto point = land_on_contact_change(path, stride.amount, stride.move.kind))
      return Outcome{std::move(point)};
  stride.amount *= path.parameters.step.cut;
  return Outcome{};
}

}  // namespace dda
