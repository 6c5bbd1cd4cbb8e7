#include "continuation/follow/judge.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> bracket_turn(PathState& path, const Candidate& candidate, Stride& stride) {
  return bracket(path, stride, before_turn(path, candidate), "a turning point of a gauge");
}

}  // namespace dda
