#include <gtest/gtest.h>

#include <numeric>

#include "continuation/linear/strips/strips.hpp"
#include "support/lattice.hpp"

namespace dda {
namespace {

/// Each block coupled with its neighbours.
BlockMatrix graph(std::size_t columns, std::size_t rows) {
  return {columns * rows, neighbours_in_columns(columns, rows)};
}

/// Where each block is: strip k is place 2k, what lies behind it place 2k + 1. Every block is somewhere, once.
std::vector<std::size_t> places(const BlockMatrix& a, const Strips& strips) {
  std::vector<std::size_t> out(a.num_rows(), a.num_rows());
  std::size_t found = 0;
  const auto put = [&](const std::vector<std::size_t>& blocks, std::size_t place) {
    EXPECT_TRUE(std::ranges::is_sorted(blocks));
    for (const std::size_t block : blocks) out[block] = place;
    found += blocks.size();
  };
  for (std::size_t k = 0; k < strips.strips.size(); ++k) put(strips.strips[k], 2 * k);
  for (std::size_t k = 0; k < strips.between.size(); ++k) put(strips.between[k], 2 * k + 1);
  EXPECT_EQ(found, a.num_rows());
  EXPECT_EQ(std::ranges::count(out, a.num_rows()), 0);
  return out;
}

void expect_apart(const BlockMatrix& a, const Strips& strips) {
  const auto at = places(a, strips);
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s) {
      const std::size_t one = at[r], other = at[a.columns()[s]];
      EXPECT_LE(std::max(one, other) - std::min(one, other), one % 2 == 1 && other % 2 == 1 ? 0u : 1u);
    }
}

TEST(Strips, AreKeptApartByWhatLiesBetween) {
  for (const std::size_t count : {1, 2, 3, 4, 7}) {
    const BlockMatrix a = graph(60, 5);
    const Strips strips = strips_of(a, std::vector<double>(count, 1.0));
    EXPECT_EQ(strips.strips.size(), count);
    EXPECT_EQ(strips.between.size(), count - 1);
    expect_apart(a, strips);
  }
}

TEST(Strips, HaveTheirShares) {
  const BlockMatrix a = graph(200, 4);
  const std::vector<double> shares{0.1, 0.3, 0.6};
  const Strips strips = strips_of(a, shares);
  ASSERT_EQ(strips.strips.size(), shares.size());
  for (std::size_t k = 0; k < shares.size(); ++k)
    EXPECT_NEAR(static_cast<double>(strips.strips[k].size()) / static_cast<double>(a.num_rows()), shares[k],
                0.05);
}

TEST(Strips, AreDividedWhereTheStructureIsNarrow) {
  // Two lattices of 10 × 6 blocks, joined by one block.
  std::vector<std::pair<BlockId, BlockId>> pairs;
  const BlockMatrix one = graph(10, 6);
  for (const std::size_t first : {std::size_t{0}, std::size_t{61}})
    for (std::size_t r = 0; r < one.num_rows(); ++r)
      for (std::size_t s = one.row_start()[r]; s < one.row_start()[r + 1]; ++s)
        if (one.columns()[s] > r) pairs.emplace_back(BlockId{first + r}, BlockId{first + one.columns()[s]});
  pairs.emplace_back(BlockId{57}, BlockId{60});
  pairs.emplace_back(BlockId{60}, BlockId{63});
  const BlockMatrix a(121, pairs);
  const Strips strips = strips_of(a, std::vector<double>{0.52, 0.48});
  ASSERT_EQ(strips.between.size(), 1u);
  EXPECT_EQ(strips.between[0].size(), 1u);
  expect_apart(a, strips);
}

TEST(Strips, FewBlocksMakeFewStrips) {
  const std::vector<double> shares(8, 1.0);
  for (const std::size_t blocks : {1, 2, 3, 5, 9}) {
    const BlockMatrix a = graph(blocks, 1);
    const Strips strips = strips_of(a, shares);
    EXPECT_LE(2 * strips.strips.size() - 1, blocks);
    for (const auto& strip : strips.strips) EXPECT_FALSE(strip.empty());
    expect_apart(a, strips);
  }
}

TEST(Strips, PiecesOfTheirOwnNeedNothingBetween) {
  std::vector<std::pair<BlockId, BlockId>> pairs;
  for (std::size_t i = 0; i + 1 < 40; ++i)
    if (i != 19) pairs.emplace_back(BlockId{i}, BlockId{i + 1});
  const BlockMatrix a(40, pairs);
  const Strips strips = strips_of(a, std::vector<double>(3, 1.0));
  expect_apart(a, strips);
}

TEST(Strips, TheBorderIsWhatLiesBeforeAndBehind) {
  const Strips strips = strips_of(graph(30, 2), std::vector<double>(3, 1.0));
  EXPECT_EQ(strips.border_of(0), strips.between[0]);
  EXPECT_EQ(strips.border_of(1).size(), strips.between[0].size() + strips.between[1].size());
  EXPECT_EQ(strips.border_of(2), strips.between[1]);
}

}  // namespace
}  // namespace dda
