#include "continuation/follow/mechanism.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda {
bool is_mechanism(const PathState& path, const State& state) {
  constexpr double far = 100;
  return path.memory.largest_displacement > 0 &&
         std::abs(path.displacement_of(state)) > far * path.memory.largest_displacement;
}

double amount_to_event(const PathState& path) {
  const double amount = next_event(path.walker);
  const bool is_far = path.releases_at_once && std::isfinite(amount) && path.walker.system().has_contacts() &&
                      is_mechanism(path, path.walker.ahead(amount));
  return is_far ? std::numeric_limits<double>::infinity() : amount;
}

bool can_slide(const PathState& path) {
  return path.walker.system().has_contacts() &&
         !(path.releases_at_once && std::isfinite(amount_to_event(path)));
}

double standing_load(const PathState& path, double load) {
  constexpr double same = 1e-6;
  return std::max(same * std::abs(load), path.smallest_load());
}

bool moves_freely(const PathState& path) {
  const double moved = std::abs(path.displacement_rate(path.walker.leaving())),
               along = mechanism_way * std::abs(path.displacement_of(path.walker.state()));
  return moved > 0 && std::abs(path.walker.leaving().rate(path.load)) * along / moved <=
                          standing_load(path, path.load_of(path.walker.state()));
}

}  // namespace dda
