#include <fmt/format.h>

#include <utility>

#include "continuation/follow/judge.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Point> snap(PathState& path, const Candidate& beyond, Stride& stride) {
  constexpr double most = 0.7;
  const double lost = missing_work(path, beyond);
  const double amount = stride.amount;
  const Stride::Before before = std::exchange(stride.before, {amount, lost});
  if (before.amount == 0 || !only_touches(path, beyond)) return {};
  const double left = lost - (before.lost - lost) * amount / (before.amount - amount);
  if (!(left / lost > most)) return {};
  const double spent = beyond.dissipated - path.walker.here().dissipated;
  auto point = jump_to(path, beyond, stride.move.kind);
  if (!point) return {};
  path.memory.step = stride.natural * unit_of(path, stride.move);
  path.report("snapped",
              fmt::format("joints held by friction snap: {:.3e} spent by it and set free", spent + lost));
  return point;
}

}  // namespace dda
