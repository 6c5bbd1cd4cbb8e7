#include <fmt/format.h>

#include "continuation/follow/landings.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> land_on_value(PathState& path, const Candidate& candidate, Stride& stride) {
  const auto crossing = first_crossing(path, candidate);
  if (!crossing || crossing->share > share_to_awaited(path, candidate)) return {};
  if (auto point = land(path, candidate, *crossing, stride.move.kind)) return Outcome{std::move(point)};
  return stop_short(stride,
                    fmt::format("no step ends on {} = {:g}, which lies on the way", crossing->landing.name,
                                crossing->landing.value),
                    crossing->share);
}

}  // namespace dda
