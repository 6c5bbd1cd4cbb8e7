#include <algorithm>
#include <cmath>

#include "continuation/follow/mechanism.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {
namespace {

constexpr double far = 0.5;

/// By more than half of all displacement so far.
bool moves_astray(const PathState& path, const State& reached, const State& ahead) {
  const double moved = std::abs(path.displacement_of(reached) - path.displacement_of(ahead)),
               largest = path.memory.largest_displacement;
  return largest > 0 && moved > far * std::max(largest, std::abs(path.displacement_of(reached)));
}

/// Under no load yet, to one against the way in which it grows: a pile that any push shakes down moves alike in both.
bool sets_out_astray(const PathState& path, const State& reached, const State& ahead) {
  const double here = path.walker.state().value(path.load), load = reached.value(path.load),
               growing = ahead.value(path.load) - here;
  return path.memory.direction == 0 && std::abs(here) <= path.smallest_load() && growing * load < 0 &&
         std::abs(load) > standing_load(path, 0);
}

/// By more than half of what a step may change the load by, where cracks grow as long as there is a load. An arc in the direction of
/// joints that slide may end at any load where they have come back.
bool falls_astray(const PathState& path, const State& reached, const State& ahead, StepKind kind) {
  const double load = path.load_of(reached), fallen = path.load_of(ahead) - load;
  const bool may_fall = path.walker.leaving().dissipates ? load > 0 : kind == StepKind::arc_length;
  return may_fall && path.memory.peak_load > 0 &&
         fallen > far * path.parameters.step.largest * path.memory.peak_load;
}

std::string stray(const PathState& path, const State& reached, const State& ahead, StepKind kind) {
  if (moves_astray(path, reached, ahead))
    return "the step strays from its tangent by more than half of all displacement so far";
  if (sets_out_astray(path, reached, ahead)) return "the load would set out against its tangent";
  if (falls_astray(path, reached, ahead, kind))
    return "the step falls off its tangent by more than half of what the load may change in one";
  return {};
}

}  // namespace

std::optional<Outcome> refuse_stray(PathState& path, const Candidate& candidate, Stride& stride) {
  const std::string why = stray(path, candidate.state, path.walker.ahead(stride.amount), stride.move.kind);
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
