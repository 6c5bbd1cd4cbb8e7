#pragma once

#include <vector>

#include "framework/base/index.hpp"
#include "meshing/geometry/polygon.hpp"

namespace dda {

/// A jump of displacement across a cut: a rigid motion of what lies on one side of it.
using JumpId = Index<struct JumpKind>;

/// What cuts have made of a block.
struct Part {
  Polygon outline;
  std::vector<JumpId> jumps;  ///< that it moves by beside the block, in the order of the cuts
};

/// A block and the straight cuts through it, each of which divides one part in two.
///
/// What lies right of a cut moves by its jump, and with it every part that hangs on that side by other cuts: so
/// across each cut the displacement jumps by its own jump alone, whatever is cut later. A cut may end on an earlier one:
/// then what it cuts off beside that one jumps there by both (`beside`).
class DividedBlock {
 public:
  explicit DividedBlock(const Polygon& outline) : parts_{{outline, {}}} {}

  /// Lengths and areas that count as nothing.
  struct Smallest {
    double length = 0;  ///< [L]
    double area = 0;    ///< [L²]
  };
  /// Divides the part that the line enters at its start and leaves at its end, be that on another cut. False, and
  /// nothing changed, where there is none, where its start lies on another cut, or where a part would be too small.
  bool divide(JumpId jump, const Vec2& start, const Vec2& end, const Smallest& smallest);

  const std::vector<Part>& parts() const { return parts_; }
  /// That contains x, or lies nearest.
  const Part& part_at(const Vec2& x) const { return parts_[nearest(x)]; }
  /// The part along whose outline one gets on in a direction from a point of a cut: what lies left of it there.
  const Part& beside(const Vec2& x, const Vec2& direction) const;
  /// Whether x lies on a cut, its ends left out.
  bool is_on_cut(const Vec2& x, double tolerance) const;

 private:
  struct Joint {
    std::size_t left, right;  ///< parts
    Vec2 start, end;
  };
  std::size_t nearest(const Vec2& x) const;
  /// Parts that hang on one side of a joint.
  std::vector<std::size_t> beyond(std::size_t part, std::size_t joint) const;

  std::vector<Part> parts_;
  std::vector<Joint> joints_;  ///< a tree: one for each cut, though two parts may lie on one side of it
};

}  // namespace dda
