#include "studies/dda/record/warnings/closed_slits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "models/body/motion.hpp"

namespace dda {
namespace {

/// Two pieces of the boundary that lie on each other.
struct Faces {
  const BoundarySide *one, *other;
};

Vec2 middle(const BoundarySide& side) { return (side.start + side.end) / 2; }

/// Pieces of different blocks that lie on each other come with the same ends the other way round (find_neighbours).
/// Compared are those above one another, by their middles.
std::vector<Faces> touching_faces(const Assembly& assembly, double tolerance) {
  std::vector<const BoundarySide*> sides;
  for (const BoundarySide& side : assembly.boundary) sides.push_back(&side);
  std::ranges::sort(sides, {}, [](const BoundarySide* side) { return middle(*side).x(); });
  std::vector<Faces> out;
  for (auto one = sides.begin(); one != sides.end(); ++one)
    for (auto other = one + 1; other != sides.end(); ++other) {
      if (middle(**other).x() - middle(**one).x() > tolerance) break;
      const bool lie_on_each_other = ((*one)->start - (*other)->end).norm() < tolerance &&
                                     ((*one)->end - (*other)->start).norm() < tolerance;
      if (lie_on_each_other && (*one)->block != (*other)->block) out.push_back({*one, *other});
    }
  return out;
}

/// The outward normal of a piece of the boundary.
Vec2 normal_of(const BoundarySide& side) {
  const Vec2 along = (side.end - side.start).normalized();
  return {along.y(), -along.x()};
}

Vec2 displacement_of(const Body& body, const BoundarySide& side, const State& state) {
  constexpr double inside = 1e-3;  // of the length of the piece: in the part that borders on it
  const Vec2 at = middle(side) - inside * (side.end - side.start).norm() * normal_of(side);
  Vec2 out = Vec2::Zero();
  for (const auto& [node, rows] : motions_at(body, side.block, at)) {
    const std::size_t first = block_unknowns * node.value();
    if (first < state.d.size())  // a state of the peak has no jumps of the cuts that came later
      out += rows * Eigen::Map<const Vec6>(state.d.data() + first);
  }
  return out;
}

/// The deepest place at which faces of slits overlap.
struct Overlap {
  double depth = 0;  ///< [L]
  Vec2 where = Vec2::Zero();
};

Overlap deepest_overlap(const Body& body, const std::vector<Faces>& slits, const State& state) {
  constexpr double seen = 0.01;  // of the largest displacement
  Overlap out;
  double largest = 0;
  for (const auto& [one, other] : slits) {
    const Vec2 u = displacement_of(body, *one, state), v = displacement_of(body, *other, state);
    largest = std::max({largest, u.norm(), v.norm()});
    const double depth = (u - v).dot(normal_of(*one));
    if (depth > out.depth) out = {depth, middle(*one)};
  }
  return out.depth > seen * largest ? out : Overlap{};
}

}  // namespace

std::string note_on_closed_slits(const Simulation& simulation, const State* peak) {
  constexpr double together = 1e-6;  // of the structure's size
  const auto slits = touching_faces(simulation.assembly(), together * simulation.equilibrium().extent());
  if (slits.empty()) return {};
  Overlap worst = deepest_overlap(simulation.body(), slits, simulation.walker().state());
  if (peak)
    if (const Overlap then = deepest_overlap(simulation.body(), slits, *peak); then.depth > worst.depth)
      worst = then;
  if (worst.depth == 0) return {};
  return fmt::format(
      "faces of a slit pass through each other by {:.2g} {} at ({:.4g}, {:.4g}): nothing is joined across a "
      "slit, and "
      "nothing is kept apart; draw it under `curves` and give it an interface with the law `friction`, which "
      "bears what "
      "closes it",
      worst.depth, simulation.deck().units.length, worst.where.x(), worst.where.y());
}

}  // namespace dda
