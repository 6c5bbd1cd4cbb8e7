#include <gtest/gtest.h>

#include "models/body/block_matrix.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

TEST(BlockMatrix, PatternHoldsDiagonalAndBothHalvesOnce) {
  const BlockMatrix a(3, {{BlockId{0}, BlockId{2}}, {BlockId{2}, BlockId{0}}, {BlockId{0}, BlockId{2}}});
  EXPECT_EQ(a.num_rows(), 3u);
  EXPECT_EQ(a.row_start(), (std::vector<std::size_t>{0, 2, 3, 5}));
  EXPECT_EQ(a.columns(), (std::vector<std::size_t>{0, 2, 1, 0, 2}));
  EXPECT_TRUE(a.value(1).isZero(0));
}

TEST(BlockMatrix, ProductEqualsTheDenseOne) {
  Random random(3);
  const std::vector<std::pair<BlockId, BlockId>> pairs{
      {BlockId{0}, BlockId{3}}, {BlockId{1}, BlockId{2}}, {BlockId{3}, BlockId{1}}};
  BlockMatrix a(4, pairs);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(24, 24);
  const auto add = [&](BlockId i, BlockId j) {
    Mat6 m;
    for (int e = 0; e < 36; ++e) m(e) = random.between(-1, 1);
    a.add(i, j, m);
    dense.block<6, 6>(static_cast<Eigen::Index>(6 * i.value()), static_cast<Eigen::Index>(6 * j.value())) +=
        m;
  };
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < 4; ++i) add(BlockId{i}, BlockId{i});
    for (const auto& [i, j] : pairs) {
      add(i, j);
      add(j, i);
    }
  }
  const std::vector<double> x = random.vector(24, 1), before = random.vector(24, 1);
  std::vector<double> y = before;
  a.multiply_add(x, y);
  using Map = Eigen::Map<const Eigen::VectorXd>;
  EXPECT_LT((Map(y.data(), 24) - Map(before.data(), 24) - dense * Map(x.data(), 24)).norm(), 1e-14);
}

}  // namespace
}  // namespace dda
