#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "meshing/assembly.hpp"
#include "meshing/cracks/divided_block.hpp"
#include "meshing/geometry/box_grid.hpp"

namespace dda {

/// A straight piece of a crack: through a block, or along a side.
struct Cut {
  BlockId block;  ///< that it divides; of a side the first of its two
  Vec2 start, end;
  int crack = 0;                         ///< to which it belongs
  std::optional<std::size_t> side = {};  ///< along which it runs, index into Assembly::sides
  bool is_provisional = true;            ///< it lies ahead of its crack and may still be aimed elsewhere

  bool is_at(const Cut& other) const {
    return crack == other.crack && start == other.start && end == other.end;
  }
  double length() const { return (end - start).norm(); }
  /// Outward of what lies left.
  Vec2 normal() const { return Vec2(end.y() - start.y(), start.x() - end.x()) / length(); }
};

/// A piece of a side on either face of which one part of a block lies.
struct SidePiece {
  Vec2 start, end;
  std::vector<JumpId> first, second;  ///< by which the parts of either block move beside it
  std::optional<std::size_t> cut;     ///< that runs along it
};

/// The same of the outer boundary.
struct BoundaryPiece {
  Vec2 start, end;
  std::vector<JumpId> jumps;
};

/// Cracks through the blocks of an assembly, which stays as it is: their cuts in the order in which they came,
/// and what these make of blocks, sides and boundary. Everything is a function of the assembly and the list of
/// cuts alone, so that the same cuts give the same bits.
///
/// Lengths below 1e-9 h and areas below 1e-9 h² are nothing, h = √(median area of the blocks).
class CrackGeometry {
 public:
  explicit CrackGeometry(const Assembly& assembly);

  const Assembly& assembly() const { return assembly_; }
  const std::vector<Cut>& cuts() const { return cuts_; }
  bool empty() const { return cuts_.empty(); }
  std::size_t num_jumps() const { return jumps_.size(); }
  const Cut& cut_of(JumpId jump) const { return cuts_[jumps_[jump.value()]]; }
  double block_size() const { return block_size_; }
  double tolerance() const { return smallest_.length; }

  /// Cuts a block from one place of its outline to another, or to a cut through it. False, and nothing changed, where
  /// that leaves too small a part, or no straight way leads from one to the other.
  bool cut(BlockId block, const Vec2& start, const Vec2& end, int crack);
  /// Opens a side between two places on it. False where they are one, or it is open there already.
  bool open(std::size_t side, const Vec2& start, const Vec2& end, int crack);
  /// Its crack has reached a cut, given by its crack and its ends: it is not provisional any more.
  void confirm(const Cut& cut);
  /// Takes the last cut back.
  void drop_last();

  /// The block into which a line leads from a point of the blocks' outlines; none outside of the body, along a
  /// side, and on cuts.
  std::optional<BlockId> block_ahead(const Vec2& tip, const Vec2& direction) const;
  /// Where the line leaves it, or meets a cut through it.
  std::optional<Vec2> exit(BlockId block, const Vec2& tip, const Vec2& direction) const;
  /// Whether another cut than the ones that end or begin there with `crack` comes to a point.
  bool is_on_crack(const Vec2& x, int crack) const;
  /// A way along a side.
  struct Way {
    std::size_t side = 0;
    Vec2 end;
    double angle = 0;  ///< from the direction wanted
  };
  /// That closest to a direction, from a point to the end of a side there; opened ones left out.
  std::optional<Way> way_along(const Vec2& tip, const Vec2& direction) const;
  /// Sides on which a point lies, their ends included.
  std::vector<std::size_t> sides_at(const Vec2& x) const;
  /// Blocks whose outline a point lies on, or which contain it.
  std::vector<BlockId> blocks_near(const Vec2& x) const;

  /// None of a block that is not cut.
  std::span<const Part> parts(BlockId block) const;
  /// By which a block moves at a point beside its own motion.
  std::span<const JumpId> jumps_at(BlockId block, const Vec2& x) const;
  /// By which what lies right of a cut through a block moves beside what lies left of it, at a point of the cut: the
  /// cut's own jump, and those of cuts that end on it.
  struct Across {
    std::vector<JumpId> right, left;
  };
  Across across(const Cut& cut, const Vec2& x) const;
  /// All jumps by which the parts on either side of a cut move, at a point of it.
  struct Beside {
    std::span<const JumpId> right, left;
  };
  Beside beside(const Cut& cut, const Vec2& x) const;
  /// Between the places at which other cuts end on it, in their order along it.
  std::vector<std::pair<Vec2, Vec2>> pieces_of_cut(const Cut& cut) const;
  /// Whether a side is divided, opened, or moved by a jump.
  bool is_touched(std::size_t side) const;
  /// Sides of which that is so, in their order.
  std::vector<std::size_t> touched_sides() const;
  /// In their order along it, one where it is not divided.
  std::vector<SidePiece> pieces_of_side(std::size_t side) const;
  std::vector<BoundaryPiece> pieces_of_boundary(std::size_t boundary_side) const;

 private:
  /// A place that a cut has marked on a side.
  struct Mark {
    std::size_t cut;
    Vec2 at;
  };
  using Marks = std::map<std::size_t, std::vector<Mark>>;
  std::vector<Vec2> stations(const Marks& marks, std::size_t side, const Vec2& start, const Vec2& end) const;
  void mark(const Cut& by);
  bool is_between(const Vec2& x, const Vec2& start, const Vec2& end) const;
  bool is_open(std::size_t side, const Vec2& x) const;
  std::optional<std::size_t> cut_along(std::size_t side, const Vec2& x) const;

  const Assembly& assembly_;
  double block_size_;
  DividedBlock::Smallest smallest_;
  BoxGrid grid_;
  std::vector<std::vector<std::size_t>> sides_of_, boundary_of_;  ///< by block
  std::vector<Cut> cuts_;
  std::vector<std::size_t> jumps_;  ///< index into cuts_ of each
  std::map<BlockId, DividedBlock> divided_;
  Marks on_sides_, on_boundary_;
};

}  // namespace dda
