#include <fmt/format.h>

#include <algorithm>

#include "continuation/follow/branch.hpp"
#include "continuation/follow/landings.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rungs.hpp"

namespace dda {
namespace {

double share_to_awaited(const PathState& path, const Candidate& candidate) {
  return path.releases_at_once || path.cracks ? share_to_strength(path, candidate) : 1;
}

/// Tries again before what could not be landed on.
Outcome stop_short(Stride& stride, std::string why, double share) {
  stride.why = std::move(why);
  stride.amount *= 0.5 * std::max(share, 0.1);
  return {};
}

}  // namespace

std::optional<Outcome> stop_at_branch(PathState& path, const Candidate& candidate, Stride& stride) {
  auto unstable = first_unstable(path, candidate, stride.amount, stride.move);
  if (!unstable) return {};
  Point point = keep(path, *std::move(unstable), stride.move.kind);
  point.landed.emplace_back("bifurcation");
  return Outcome{std::move(point)};
}

std::optional<Outcome> land_on_value(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto crossing = first_crossing(path, candidate);
  if (!crossing || crossing->share > share_to_awaited(path, candidate)) return {};
  if (auto point = land(path, candidate, *crossing, stride.move.kind)) return Outcome{std::move(point)};
  return stop_short(stride,
                    fmt::format("no step ends on {} = {:g}, which lies on the way", crossing->landing.name,
                                crossing->landing.value),
                    crossing->share);
}

std::optional<Outcome> land_at_strength(PathState& path, const Candidate& candidate, Stride& stride) {
  const double share = share_to_awaited(path, candidate);
  if (share >= 1) return {};
  if (auto point = land_on_strength(path, candidate, stride.move.kind)) return Outcome{std::move(point)};
  return stop_short(stride, "no step ends where the next point reaches its strength", share);
}

std::optional<Outcome> go_on(PathState& path, const Candidate& candidate, Stride& stride) {
  if (stride.beyond > 0) {  // how far away a strength was is no measure of the path
    path.memory.step = stride.beyond * unit_of(path, stride.move);
    path.memory.step_kind = stride.move.kind;
  } else {
    resize(path, candidate, stride.amount, stride.move);
  }
  note_looks(path, stride.looked, candidate);
  path.memory.step = std::max(path.memory.step, stride.looked_at);  // what was hidden is behind
  return Outcome{keep(path, candidate, stride.move.kind)};
}

}  // namespace dda
