#include <algorithm>

#include "continuation/follow/judge.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {
namespace {

constexpr int most_looks = 7;  // between the ends of one step

}  // namespace

std::optional<Outcome> look_between(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto share = before_hidden_turn(path, candidate, stride.amount);
  if (!share || stride.looks++ >= most_looks) return {};
  stride.looked.for_peak = stride.looked.for_peak || may_hide_peak(path, candidate);
  stride.looked.for_turn = stride.looked.for_turn || may_hide_turns(path, candidate);
  stride.looked_at = std::max(stride.looked_at, stride.amount);
  return shorten(path, stride, "the step may hide a turn between its ends", *share);
}

}  // namespace dda
