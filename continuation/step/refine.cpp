#include <algorithm>
#include <cmath>

#include "continuation/follow/judge.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rungs.hpp"

namespace dda {
namespace {

constexpr int most_refinements = 20;  ///< of one step
constexpr int most_looks = 7;         ///< between the ends of one step

Outcome shorten(PathState& path, Stride& stride, const std::string& why, double share) {
  stride.why = why;
  path.report("refined", why);
  ++path.walker.effort().rejected;
  stride.amount *= share;
  return {};
}

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

std::optional<Outcome> bracket_peak(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto share = before_peak(path, candidate);
  if (!share || stride.refinements++ >= most_refinements) return {};
  return shorten(path, stride, "the step crosses the limit point", *share);
}

std::optional<Outcome> bracket_turn(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto share = before_turn(path, candidate);
  if (!share || stride.refinements++ >= most_refinements) return {};
  return shorten(path, stride, "the step crosses a turning point of a gauge", *share);
}

std::optional<Outcome> look_between(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto share = before_hidden_turn(path, candidate, stride.amount);
  if (!share || stride.looks++ >= most_looks) return {};
  stride.looked.for_peak = stride.looked.for_peak || may_hide_peak(path, candidate);
  stride.looked.for_turn = stride.looked.for_turn || may_hide_turns(path, candidate);
  stride.looked_at = std::max(stride.looked_at, stride.amount);
  return shorten(path, stride, "the step may hide a turn between its ends", *share);
}

std::optional<Outcome> refine_coarse(PathState& path, const Candidate& candidate, Stride& stride) {
  if (!is_coarse(path, candidate)) return {};
  if (stride.refinements++ < most_refinements) {
    if (!path.walker.leaving().dissipates && stride.refinements > 1)
      if (auto point = land_on_contact_change(path, stride.amount, stride.move.kind))
        return Outcome{std::move(point)};
    if (auto point = snap(path, candidate, stride)) return Outcome{std::move(point)};
    return shorten(path, stride, "the step leaves too much energy unaccounted for", 0.5);
  }
  if (!refuse_jump(path, candidate, to_string(stride.move.kind))) return {};
  stride.why = path.refusal;
  stride.amount *= path.parameters.step.cut;
  return Outcome{};
}

}  // namespace dda
