#include "continuation/linear/strips/strips.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace dda {
namespace {

using Blocks = std::vector<std::size_t>;

/// Blocks by their distance from one, for those that can be reached from it.
std::vector<Blocks> levels_from(const BlockMatrix& a, std::size_t start, std::vector<bool>& is_seen) {
  std::vector<Blocks> out{{start}};
  is_seen[start] = true;
  while (!out.back().empty()) {
    Blocks next;
    for (const std::size_t block : out.back())
      for (std::size_t s = a.row_start()[block]; s < a.row_start()[block + 1]; ++s)
        if (const std::size_t other = a.columns()[s]; !is_seen[other]) {
          is_seen[other] = true;
          next.push_back(other);
        }
    out.push_back(std::move(next));
  }
  out.pop_back();
  return out;
}

/// From a block at an end of its piece: as far as can be from one that is as far as can be from any.
std::vector<Blocks> levels_of_piece(const BlockMatrix& a, std::size_t any, std::vector<bool>& is_seen) {
  constexpr int searches = 2;
  for (int i = 0; i < searches; ++i) {
    const std::vector<Blocks> levels = levels_from(a, any, is_seen);
    for (const Blocks& level : levels)
      for (const std::size_t block : level) is_seen[block] = false;
    any = levels.back().front();
  }
  return levels_from(a, any, is_seen);
}

/// Of all pieces, one behind the other.
std::vector<Blocks> all_levels(const BlockMatrix& a) {
  std::vector<bool> is_seen(a.num_rows(), false);
  std::vector<Blocks> out;
  for (std::size_t block = 0; block < a.num_rows(); ++block) {
    if (is_seen[block]) continue;
    std::vector<Blocks> piece = levels_of_piece(a, block, is_seen);
    std::ranges::move(piece, std::back_inserter(out));
  }
  return out;
}

/// The smallest level from `first` on before whose middle about the wanted number of blocks stands.
std::size_t smallest_near(const std::vector<std::size_t>& before, std::size_t first, double wanted,
                          double tolerance) {
  const std::size_t last = before.size() - 2;  // something comes behind it
  std::size_t out = last;
  double best = -1;
  for (std::size_t level = first; level < last; ++level) {
    const auto size = static_cast<double>(before[level + 1] - before[level]);
    const double off = std::abs(static_cast<double>(before[level]) + size / 2 - wanted);
    const double cost = off <= tolerance ? size : size + static_cast<double>(before.back()) * off;
    if (best >= 0 && cost >= best) continue;
    best = cost;
    out = level;
  }
  return out;
}

/// Blocks of a level with neighbours in the next one; the others belong to the strip before.
Blocks split_off(const BlockMatrix& a, const Blocks& level, Blocks next, Blocks& before) {
  std::ranges::sort(next);
  Blocks out;
  for (const std::size_t block : level) {
    const auto columns =
        std::span(a.columns()).subspan(a.row_start()[block], a.row_start()[block + 1] - a.row_start()[block]);
    const bool is_between =
        std::ranges::any_of(columns, [&](std::size_t c) { return std::ranges::binary_search(next, c); });
    (is_between ? out : before).push_back(block);
  }
  return out;
}

}  // namespace

std::vector<std::size_t> Strips::border_of(std::size_t strip) const {
  Blocks out;
  if (strip > 0) out = between[strip - 1];
  if (strip < between.size()) out.insert(out.end(), between[strip].begin(), between[strip].end());
  return out;
}

Strips strips_of(const BlockMatrix& a, std::span<const double> shares) {
  constexpr double near = 0.08;  // of a strip's share, before and behind
  const std::vector<Blocks> levels = all_levels(a);
  std::vector<std::size_t> before{0};
  for (const Blocks& level : levels) before.push_back(before.back() + level.size());
  const double per_share = static_cast<double>(a.num_rows()) / std::reduce(shares.begin(), shares.end());
  Strips out{{{}}, {}};
  std::size_t next = 0;
  double wanted = 0;
  const auto fill = [&](std::size_t end) {
    for (; next < end; ++next)
      out.strips.back().insert(out.strips.back().end(), levels[next].begin(), levels[next].end());
  };
  for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
    wanted += shares[k] * per_share;
    if (next + 2 >= levels.size()) break;  // nothing would be left behind what lies between
    const std::size_t level = smallest_near(before, next + 1, wanted, near * shares[k] * per_share);
    fill(level);
    Blocks between = split_off(a, levels[level], levels[level + 1], out.strips.back());
    out.between.push_back(std::move(between));
    out.strips.emplace_back();
    ++next;
  }
  fill(levels.size());
  for (std::vector<Blocks>* all : {&out.strips, &out.between})
    for (Blocks& blocks : *all) std::ranges::sort(blocks);
  return out;
}

}  // namespace dda
