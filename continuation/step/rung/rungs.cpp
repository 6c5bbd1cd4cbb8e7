#include "continuation/step/rung/rungs.hpp"

#include <algorithm>

#include "continuation/follow/landings.hpp"

namespace dda {

Outcome shorten(PathState& path, Stride& stride, const std::string& why, double share) {
  stride.why = why;
  path.report("refined", why);
  ++path.walker.effort().rejected;
  stride.amount *= share;
  return {};
}

std::optional<Outcome> bracket(PathState& path, Stride& stride, const std::optional<double>& share,
                               const std::string& what) {
  if (!share || stride.refinements++ >= most_refinements) return {};
  return shorten(path, stride, "the step crosses " + what, *share);
}

Outcome stop_short(Stride& stride, std::string why, double share) {
  stride.why = std::move(why);
  stride.amount *= 0.5 * std::max(share, 0.1);
  return {};
}

double share_to_awaited(const PathState& path, const Candidate& candidate) {
  return path.releases_at_once || path.cracks ? share_to_strength(path, candidate) : 1;
}

}  // namespace dda
