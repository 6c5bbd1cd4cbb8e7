#include "studies/dda/record/warnings/large_movements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

/// How far a block turns or strains, by d = (u0, v0, r0, εx, εy, γxy).
struct Movement {
  double turn = 0, strain = 0;
  double most() const { return std::max(turn, strain); }
};

Movement movement_of(const double* d) {
  const double mean = (d[3] + d[4]) / 2;
  return {std::abs(d[2]), std::abs(mean) + std::hypot((d[3] - d[4]) / 2, d[5] / 2)};
}

}  // namespace

std::string note_on_large_movements(const Simulation& simulation) {
  constexpr double small = 0.1;
  const std::vector<double>& d = simulation.walker().state().d;
  Movement worst;
  std::size_t block = 0;
  for (std::size_t b = 0; b < simulation.assembly().num_blocks(); ++b) {
    const Movement now = movement_of(d.data() + block_unknowns * b);
    if (!(now.most() > worst.most())) continue;
    worst = now;
    block = b;
  }
  if (worst.most() <= small) return {};
  const Vec2 at = simulation.assembly().blocks[block].moments.centroid;
  const bool turns = worst.turn > worst.strain;
  return fmt::format(
      "block {} at ({:.4g}, {:.4g}) is {} by {:.2g} at the end, which is not small: contacts and arms of "
      "forces of a path are those of the undeformed shape; end it before by `path.stop`, and let `motion` "
      "go on, which turns blocks by any angle",
      block, at.x(), at.y(), turns ? "turned" : "strained", worst.most());
}

}  // namespace dda
