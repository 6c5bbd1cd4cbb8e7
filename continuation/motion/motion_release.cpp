// Which bodies of a motion may meet: those that nothing joins any more.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "continuation/motion/motion.hpp"

namespace dda {
namespace {

using Pairs = std::vector<MeetingSearch::Pair>;

/// Adds to `joined` all pairs of some bodies that a chain of bonded ones, in order, connects.
void join_chains(const std::vector<std::uint32_t>& bodies, const Pairs& bonded, Pairs& joined) {
  std::vector<std::size_t> chain(bodies.size());
  std::iota(chain.begin(), chain.end(), std::size_t{0});
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const auto pair = std::minmax(bodies[a], bodies[b]);
      if (!std::ranges::binary_search(bonded, MeetingSearch::Pair(pair))) continue;
      const std::size_t from = chain[b], to = chain[a];
      std::ranges::replace(chain, from, to);
    }
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size(); ++b)
      if (chain[a] == chain[b]) joined.push_back(std::minmax(bodies[a], bodies[b]));
}

MeetingSearch::Pair pair_of(const Bond& bond) {
  return std::minmax(static_cast<std::uint32_t>(bond.first), static_cast<std::uint32_t>(bond.second));
}

void sort(Pairs& pairs) {
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
}

}  // namespace

/// Whether the sides of a spent bond face each other no more.
bool Motion::has_left(const Bond& bond) const {
  constexpr double turn = 0.2, way = 0.1;
  if (!bond.is_spent()) return false;
  const auto angle = [this](std::size_t b) { return polar_of(gradient_of(now_[b])).angle; };
  const Vec2 jump = place_of(now_[bond.second], bond.at_second) - place_of(now_[bond.first], bond.at_first);
  const double size = std::min(scene_.bodies[bond.first].size, scene_.bodies[bond.second].size);
  return std::abs(std::remainder(angle(bond.second) - angle(bond.first), 2 * M_PI)) > turn ||
         jump.norm() > way * size;
}

/// Bodies that a bond joins, or a chain of them around a corner, do not meet. Where the last is spent its law goes on
/// to bear pressure as long as its sides face each other, and until they are apart they do not meet: outlines that have
/// overlapped as bonded bodies may tell no outside.
void Motion::release() {
  Pairs bonded;
  for (const Bond& bond : bonds_)
    if (!bond.is_spent()) bonded.push_back(pair_of(bond));
  sort(bonded);
  Pairs joined = bonded;
  for (const auto& blocks : scene_.around) join_chains(blocks, bonded, joined);
  sort(joined);
  Pairs waiting;
  for (const MeetingSearch::Pair& pair : m_.joined)
    if (!std::ranges::binary_search(joined, pair) && !search_->are_apart(pair, now_)) waiting.push_back(pair);
  joined.insert(joined.end(), waiting.begin(), waiting.end());
  sort(joined);
  const auto is_gone = [&](const Bond& bond) {
    return !std::ranges::binary_search(joined, pair_of(bond)) || has_left(bond);
  };
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    if (!is_gone(bonds_[i])) left.push_back(m_.bonds[i]);
  std::erase_if(bonds_, is_gone);
  const bool is_same = potential_ && left == m_.bonds && joined == m_.joined;
  m_.bonds = std::move(left);
  m_.is_released = waiting.empty() && std::ranges::none_of(bonds_, &Bond::is_spent);
  if (is_same) return;
  m_.joined = std::move(joined);
  make_solver();
}

}  // namespace dda
