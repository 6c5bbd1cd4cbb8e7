#include "studies/dda/record/warnings/cracks_left_out.hpp"

#include <fmt/format.h>

namespace dda {

std::string note_on_cracks_left_out(const Simulation& simulation) {
  constexpr double beyond = 1.1;
  const CrackedStructure* cracked = simulation.cracked();
  if (!cracked) return {};
  const State& end = simulation.walker().state();
  const auto place =
      cracked->front().left_out(cracked->stress(simulation.loading(), end.d.all(), end.load_factor));
  if (!place || place->start.load_factor * beyond >= 1) return {};
  const Vec2& at = place->start.at;
  return fmt::format(
      "tension at ({:.4g}, {:.4g}) is {:.3g} times the strength at the end, and no crack of `cracks` may "
      "begin there: more "
      "may by `most`, closer to each other by `apart`",
      at.x(), at.y(), 1 / place->start.load_factor);
}

}  // namespace dda
