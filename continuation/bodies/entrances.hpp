#pragma once

#include <vector>

#include "continuation/bodies/meetings.hpp"

namespace dda {

/// Which corner of one body may come in through which edge of another, and how far it is outside.
///
/// A corner may enter through an edge when both its own edges lead away from the other body (by an angle of 3°, in which
/// they count as parallel), and its foot is on the edge or, at a notch, behind its end. Where corner is near corner all edges through which either may
/// enter the other are asked, and the one counts that is farthest outside: before it is crossed nothing overlaps. Bodies
/// that overlap by more than the reach do not see each other there.
///
///     gap g = n · (x − foot)      n the outward normal of the edge; < 0 inside
///
/// Meetings have g as their distance and no stiffness; `is_corner` tells of corners near corners. Source: Shi (1988, 2015).
class EntranceSearch {
 public:
  EntranceSearch(const MovingScene& scene, const MeetingSearch& search, double reach)
      : scene_(scene), search_(search), reach_(reach) {}

  /// All that is nearer than the reach, in order.
  std::vector<Meeting> find(const Poses& at) const;

 private:
  const MovingScene& scene_;
  const MeetingSearch& search_;
  double reach_;  ///< [L]
};

}  // namespace dda
