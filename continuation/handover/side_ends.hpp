#pragma once

#include <vector>

#include "continuation/handover/handover.hpp"

namespace dda {

/// Bonds at the ends of sides whose points are inside them, as Gauss points are. On the path such a side turns about one of
/// its points, and its corner sinks into what is beside it; in motion nothing may. They bear pressure alone, with the
/// stiffness of the joint:
///
///     t_n = k min(q_n + g, 0)
///
/// g is what they overlap by at the handover, so that this sets nothing free.
struct SideEnds {
  /// Of joints that hold, which they leave alone: g is a twentieth of the offset s more.
  std::vector<Bond> of_joints;
  /// Of what only touches, or has torn: where they overlap by less than a twentieth of s, g = 0.
  std::vector<Bond> of_contacts;
  /// Pairs of these that overlap by more, in order: until they have parted they bear on each other by their joints.
  std::vector<MeetingSearch::Pair> overlapping;
};
SideEnds ends_of_sides(const Pieces& pieces, const Equilibrium& whole, const Handover& from);

}  // namespace dda
