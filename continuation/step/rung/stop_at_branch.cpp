#include "continuation/follow/branch.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> stop_at_branch(PathState& path, const Candidate& candidate, Stride& stride) {
  auto unstable = first_unstable(path, candidate, stride.amount, stride.move);
  if (!unstable) return {};
  Point point = keep(path, *std::move(unstable), stride.move.kind);
  point.landed.emplace_back("bifurcation");
  return Outcome{std::move(point)};
}

}  // namespace dda
