#include "meshing/cracks/parted.hpp"

#include <algorithm>
#include <stdexcept>

namespace dda {

std::size_t Parted::at(BlockId whole, std::span<const JumpId> jumps) const {
  for (const std::size_t b : of_whole[whole.value()])
    if (std::ranges::equal(pieces[b].jumps, jumps)) return b;
  throw std::logic_error("no part of the block moves by these jumps");
}

namespace {

void add_blocks(const CrackGeometry& cracks, Parted& out) {
  const std::vector<Block>& blocks = cracks.assembly().blocks;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const BlockId id{b};
    std::vector<std::size_t>& own = out.of_whole.emplace_back();
    const auto add = [&](Block block, std::vector<JumpId> jumps) {
      own.push_back(out.assembly.blocks.size());
      out.assembly.blocks.push_back(std::move(block));
      out.pieces.push_back({id, std::move(jumps)});
    };
    if (cracks.parts(id).empty()) add(blocks[b], {});
    for (const Part& part : cracks.parts(id))
      add({part.outline, moments(part.outline), blocks[b].region}, part.jumps);
  }
}

void add_sides(const CrackGeometry& cracks, Parted& out) {
  const std::vector<Side>& sides = cracks.assembly().sides;
  for (std::size_t s = 0; s < sides.size(); ++s)
    for (const SidePiece& piece : cracks.pieces_of_side(s))
      out.assembly.sides.push_back({BlockId{out.at(sides[s].first, piece.first)},
                                    BlockId{out.at(sides[s].second, piece.second)}, piece.start, piece.end,
                                    sides[s].curve});
  for (const Cut& cut : cracks.cuts()) {
    if (cut.side) continue;
    for (const auto& [start, end] : cracks.pieces_of_cut(cut)) {
      const CrackGeometry::Beside beside = cracks.beside(cut, (start + end) / 2);
      out.assembly.sides.push_back({BlockId{out.at(cut.block, beside.left)},
                                    BlockId{out.at(cut.block, beside.right)}, start, end, std::nullopt});
    }
  }
}

void add_boundary(const CrackGeometry& cracks, Parted& out) {
  const std::vector<BoundarySide>& boundary = cracks.assembly().boundary;
  for (std::size_t s = 0; s < boundary.size(); ++s)
    for (const BoundaryPiece& piece : cracks.pieces_of_boundary(s))
      out.assembly.boundary.push_back(
          {BlockId{out.at(boundary[s].block, piece.jumps)}, piece.start, piece.end, boundary[s].boundary});
}

}  // namespace

Parted parted(const CrackGeometry& cracks) {
  const Assembly& whole = cracks.assembly();
  Parted out;
  out.assembly.regions = whole.regions;
  out.assembly.curves = whole.curves;
  out.assembly.boundaries = whole.boundaries;
  out.assembly.points = whole.points;
  add_blocks(cracks, out);
  add_sides(cracks, out);
  add_boundary(cracks, out);
  return out;
}

}  // namespace dda
