#include "studies/dda/record/warnings/torn_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "meshing/quality.hpp"
#include "studies/dda/record/warnings/strength_left.hpp"

namespace dda {
namespace {

/// Of the energy: where so much is spent, the structure has failed.
constexpr double most_energy = 0.5;
/// Around a bearing's point that is still its place, in sizes of its blocks.
constexpr double reach = 2.5;

/// Sides with a point that still has some strength.
std::vector<bool> holding_sides(const Simulation& simulation, const std::vector<History>& history) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  std::vector<bool> holds(simulation.assembly().sides.size(), false);
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    if (equilibrium.point(p).cut) continue;
    if (p >= history.size() || holds_still(equilibrium.point(p), history[p]))
      holds[equilibrium.point(p).side] = true;
  }
  return holds;
}

/// Of all energy spent, where `is_meant` says so of a point.
template <class IsMeant>
double energy_share(const Simulation& simulation, const std::vector<History>& history, IsMeant is_meant) {
  double here = 0, all = 0;
  for (std::size_t p = 0; p < history.size(); ++p) {
    const InterfacePoint& point = simulation.equilibrium().point(p);
    const double spent = point.weight * history[p].dissipated;
    all += spent;
    if (is_meant(point)) here += spent;
  }
  return all > 0 ? here / all : 0;
}

/// Pieces that released joints cut off.
std::vector<TornPiece> released_pieces(const Simulation& simulation, const std::vector<History>& history) {
  const Assembly& assembly = simulation.assembly();
  const auto parts = connected_groups(assembly, holding_sides(simulation, history));
  std::vector<TornPiece> out;
  bool is_split = false;
  for (const Bearing& bearing : bearings_of(simulation))
    for (const BlockId at : bearing.blocks) {  // blocks that share a point may be torn out one by one
      const std::vector<BlockId>& piece =
          *std::ranges::find_if(parts, [&](const auto& part) { return is_member(part, at); });
      const double whole = area_around(assembly, at), area = area_of(assembly, piece);
      is_split = is_split || (area > small_share * whole && area < whole / 2);
      if (area > small_share * whole) continue;
      const double share = energy_share(simulation, history, [&](const InterfacePoint& point) {
        return is_member(piece, point.first) || is_member(piece, point.second);
      });
      out.push_back({bearing, piece, share});
    }
  // What is small where the structure itself has parted is a splinter of its failure, unless it took most.
  if (is_split) std::erase_if(out, [](const TornPiece& piece) { return piece.share < most_energy; });
  return out;
}

/// Bearings around which most of the energy has been spent; no wonder where that is much of the structure.
std::vector<TornPiece> softened_places(const Simulation& simulation, const std::vector<History>& history) {
  const Assembly& assembly = simulation.assembly();
  std::vector<TornPiece> out;
  for (const Bearing& bearing : bearings_of(simulation)) {
    const double radius = reach * size_of(assembly, bearing);
    const double half_disc = std::numbers::pi / 2 * radius * radius;
    if (half_disc > 2 * small_share * area_around(assembly, bearing.blocks.front())) continue;
    const double share = energy_share(simulation, history, [&](const InterfacePoint& point) {
      return (point.x - bearing.at).norm() <= radius;
    });
    if (share >= most_energy) out.push_back({bearing, bearing.blocks, share});
  }
  return out;
}

bool shares_block(const TornPiece& a, const TornPiece& b) {
  return std::ranges::any_of(a.blocks, [&](BlockId id) { return is_member(b.blocks, id); });
}

Vec2 centroid_of(const Assembly& assembly, const std::vector<BlockId>& blocks) {
  Vec2 sum = Vec2::Zero();
  for (const BlockId id : blocks)
    sum += assembly.blocks[id.value()].moments.area * assembly.blocks[id.value()].moments.centroid;
  return sum / area_of(assembly, blocks);
}

}  // namespace

std::vector<TornPiece> torn_pieces(const Simulation& simulation, const std::vector<History>& history,
                                   bool has_fallen) {
  std::vector<TornPiece> found = released_pieces(simulation, history), out;
  if (has_fallen) std::ranges::move(softened_places(simulation, history), std::back_inserter(found));
  for (TornPiece& piece : found)
    if (std::ranges::none_of(out, [&](const TornPiece& known) { return shares_block(known, piece); }))
      out.push_back(std::move(piece));
  return out;
}

std::string text(const Simulation& simulation, const TornPiece& piece) {
  const Vec2 at = centroid_of(simulation.assembly(), piece.blocks);
  return fmt::format(
      "{} has been torn out of the structure: {:.0f} % of all energy was spent around {} at ({:.6g}, "
      "{:.6g}). The "
      "peak may be that of this place, not of the structure; {}",
      piece.bearing.name, 100 * piece.share,
      piece.blocks.size() == 1 ? "the block" : fmt::format("the {} blocks", piece.blocks.size()), at.x(),
      at.y(), patch_proposal(simulation.assembly(), piece.bearing));
}

nlohmann::ordered_json to_json(const Simulation& simulation, const std::vector<TornPiece>& pieces) {
  auto out = nlohmann::ordered_json::array();
  for (const TornPiece& piece : pieces) {
    const Vec2 at = centroid_of(simulation.assembly(), piece.blocks);
    auto blocks = nlohmann::ordered_json::array();
    for (const BlockId id : piece.blocks) blocks.push_back(id.value());
    out.push_back({{"bearing", piece.bearing.name},
                   {"blocks", blocks},
                   {"at", {at.x(), at.y()}},
                   {"share_of_energy", piece.share}});
  }
  return out;
}

}  // namespace dda
