#include "continuation/follow/judge.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> bracket_peak(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto share = before_peak(path, candidate);
  if (!share || stride.refinements++ >= most_refinements) return {};
  return shorten(path, stride, "the step crosses the limit point", *share);
}

}  // namespace dda
