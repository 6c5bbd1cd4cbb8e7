#pragma once

#include <string>
#include <vector>

#include "models/interface_point.hpp"

namespace dda {

/// Joints with multipliers that lock because corners of blocks do not meet, one notice for each interface.
///
/// Where a block b faces two blocks a, a', bonded (by mortar that is intact, too) to each other at a corner within
/// b's side (a T-joint), two exact points on each piece tie both to b's displacement, which is affine along
/// the side: u_a = u_b = u_a'. From T-joint to T-joint the whole joint is tied to one affine displacement,
/// and what that takes is borne by the shortest pieces (a thousand times the pressure on pieces of a
/// thousandth of a side). Between blocks that are free to part, dry bricks in a course, nothing locks.
std::vector<std::string> locked_joints(const Body& body, const InterfaceSet& interfaces);

}  // namespace dda
