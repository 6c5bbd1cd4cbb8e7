// Which bodies of a motion may meet: those that nothing joins any more.
#include <algorithm>
#include <cmath>

#include "continuation/bodies/joined.hpp"
#include "continuation/motion/motion.hpp"

namespace dda {
namespace {

using Pairs = std::vector<MeetingSearch::Pair>;

}  // namespace

/// Whether the sides of a bond that holds nothing face each other no more.
bool Motion::has_left(const Bond& bond) const {
  constexpr double turn = 0.2, way = 0.1;
  if (!bond.is_spent() && !bond.is_end) return false;
  const Vec2 jump = place_of(now_[bond.second], bond.at_second) - place_of(now_[bond.first], bond.at_first);
  const double size = std::min(scene_.bodies[bond.first].size, scene_.bodies[bond.second].size);
  return turn_of(bond, now_) > turn || jump.norm() > way * size;
}

/// Pairs that bear on each other by what is left of their joints; in order.
std::vector<MeetingSearch::Pair> Motion::bearing_pairs() const {
  Pairs out;
  for (const Bond& bond : bonds_)
    if (!has_left(bond)) out.push_back(pair_of(bond));
  std::ranges::sort(out);
  return out;
}

/// Whether two bodies that have been joined meet like others from now on: apart, or turned away from each other with so
/// little overlap at a corner that this sets nothing free.
bool Motion::may_meet(const MeetingSearch::Pair& pair,
                      const std::vector<MeetingSearch::Pair>& bearing) const {
  constexpr double overlap = 1.0 / 64;  // of the reach 2s
  return search_->are_apart(pair, now_, scene_.meeting.reach) ||
         (!std::ranges::binary_search(bearing, pair) &&
          search_->are_apart(pair, now_, (1 - overlap) * scene_.meeting.reach));
}

/// Bodies that a bond joins, or a chain of them around a corner, do not meet. Where the last is spent its law goes on
/// to bear pressure, and so do the ends of sides, until the bodies meet: outlines that have overlapped as bonded bodies may
/// tell no outside.
void Motion::release() {
  Pairs joined = joined_by(bonds_, scene_.around);
  const Pairs bearing = bearing_pairs();
  Pairs waiting;
  for (const MeetingSearch::Pair& pair : m_.joined)
    if (!std::ranges::binary_search(joined, pair) && !may_meet(pair, bearing)) waiting.push_back(pair);
  joined.insert(joined.end(), waiting.begin(), waiting.end());
  std::ranges::sort(joined);
  const auto is_gone = [&](const Bond& bond) { return !std::ranges::binary_search(joined, pair_of(bond)); };
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    if (!is_gone(bonds_[i])) left.push_back(m_.bonds[i]);
  std::erase_if(bonds_, is_gone);
  const bool is_same = potential_ && left == m_.bonds && joined == m_.joined;
  m_.bonds = std::move(left);
  joined_ = JoinedBodies(scene_, bonds_);
  m_.is_released = waiting.empty() && std::ranges::none_of(bonds_, &Bond::is_spent);
  if (is_same) return;
  m_.joined = std::move(joined);
  make_solver();
}

}  // namespace dda
