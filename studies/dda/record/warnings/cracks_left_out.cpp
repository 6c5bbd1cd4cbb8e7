#include "studies/dda/record/warnings/cracks_left_out.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace dda {
namespace {

std::string note_at(const Simulation& simulation, const State& state, double beyond, const char* when) {
  const CrackedStructure& cracked = *simulation.cracked();
  const auto place =
      cracked.front().left_out(cracked.stress(simulation.loading(), state.d.all(), state.load_factor));
  if (!place || place->start.load_factor * beyond >= 1) return {};
  const Vec2& at = place->start.at;
  return fmt::format(
      "tension at ({:.4g}, {:.4g}) is {:.3g} times the strength at the {}, and no crack of `cracks` may "
      "begin there: {}",
      at.x(), at.y(), 1 / place->start.load_factor, when,
      simulation.deck().cracks[place->entry].is_automatic()
          ? "more may by `most`, closer to each other by `apart`"
          : "name the place by `begin`, too, or let them begin by themselves: `begin: automatic`");
}

}  // namespace

std::string note_on_cracks_left_out(const Simulation& simulation, const State* peak) {
  constexpr double at_end = 1.1, at_peak = 1.5;
  if (!simulation.cracked()) return {};
  std::string out = note_at(simulation, simulation.walker().state(), at_end, "end");
  if (out.empty() && peak) out = note_at(simulation, *peak, at_peak, "peak");
  return out;
}

std::string note_on_shallow_corners(const Simulation& simulation) {
  if (!simulation.cracked()) return {};
  const auto corners = simulation.cracked()->front().shallow_corners();
  const auto least = std::ranges::min_element(corners, {}, &ShallowCorner::depth);
  if (least == corners.end()) return {};
  return fmt::format(
      "the body is {:.2g} blocks deep ahead of the corner at ({:.4g}, {:.4g}): with less than four they do "
      "not tell well "
      "whether a crack begins there by itself, and peaks may be tens of percent too high; make blocks {:.2g} "
      "times as "
      "large, or name the place by `begin`",
      least->depth, least->at.x(), least->at.y(), least->depth / 4);
}

}  // namespace dda
