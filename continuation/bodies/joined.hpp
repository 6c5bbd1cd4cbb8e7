#pragma once

#include "continuation/bodies/bonds.hpp"
#include "continuation/bodies/meetings.hpp"

namespace dda {

/// The two bodies of a bond, in order.
MeetingSearch::Pair pair_of(const Bond& bond);

/// In order, each once.
void put_in_order(std::vector<MeetingSearch::Pair>& pairs);

/// Pairs of bodies that a bond holds, or a chain of such bonds around a corner that they have in
/// common: in order, each once.
std::vector<MeetingSearch::Pair> joined_by(const std::vector<Bond>& bonds,
                                           const std::vector<std::vector<std::uint32_t>>& around);

}  // namespace dda
