#pragma once

#include <vector>

#include "framework/base/vec2.hpp"

namespace dda::svg {

/// The room of a mark on the picture: what is nearer to the way from one end to the other than its breadth [px].
struct Footprint {
  Vec2 from, to;
  Vec2 anchor;  ///< the place of which it tells
  double breadth = 0;

  Footprint shifted(const Vec2& by) const { return {from + by, to + by, anchor + by, breadth}; }
  /// Whether they cover each other, but for ends that meet at an anchor, as two supports at a corner do.
  bool covers(const Footprint& other) const;
};

/// Marks that stand at one place are put side by side.
class Footprints {
 public:
  /// By how much to move a mark across its direction: nothing where none that stands at the same place would cover it, or
  /// where there is no room nearby.
  Vec2 shift_of(const Footprint& mark, const Vec2& direction) const;
  void add(const Footprint& mark) { marks_.push_back(mark); }

 private:
  std::vector<Footprint> marks_;
};

}  // namespace dda::svg
