#include "continuation/follow/judge.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> bracket_turn(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto share = before_turn(path, candidate);
  if (!share || stride.refinements++ >= most_refinements) return {};
  return shorten(path, stride, "the step crosses a turning point of a gauge", *share);
}

}  // namespace dda
