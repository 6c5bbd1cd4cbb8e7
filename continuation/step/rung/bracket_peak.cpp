#include "continuation/follow/judge.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> bracket_peak(PathState& path, const Candidate& candidate, Stride& stride) {
  return bracket(path, stride, before_peak(path, candidate), "the limit point");
}

}  // namespace dda
