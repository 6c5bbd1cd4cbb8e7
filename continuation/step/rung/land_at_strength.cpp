#include "continuation/follow/landings.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> land_at_strength(PathState& path, const Candidate& candidate, Stride& stride) {
  const double share = share_to_awaited(path, candidate);
  if (share >= 1) return {};
  if (auto point = land_on_strength(path, candidate, stride.move.kind)) return Outcome{std::move(point)};
  return stop_short(stride, "no step ends where the next point reaches its strength", share);
}

}  // namespace dda
