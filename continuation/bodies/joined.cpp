#include "continuation/bodies/joined.hpp"

#include <algorithm>
#include <numeric>

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

}  // namespace

void put_in_order(Pairs& pairs) {
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
}

MeetingSearch::Pair pair_of(const Bond& bond) {
  return std::minmax(static_cast<std::uint32_t>(bond.first), static_cast<std::uint32_t>(bond.second));
}

std::vector<MeetingSearch::Pair> joined_by(const std::vector<Bond>& bonds,
                                           const std::vector<std::vector<std::uint32_t>>& around) {
  Pairs bonded;
  for (const Bond& bond : bonds)
    if (bond.holds()) bonded.push_back(pair_of(bond));
  put_in_order(bonded);
  Pairs out = bonded;
  for (const auto& bodies : around) join_chains(bodies, bonded, out);
  put_in_order(out);
  return out;
}

}  // namespace dda
