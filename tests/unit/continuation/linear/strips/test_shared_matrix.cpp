#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "continuation/linear/strips/shared_matrix.hpp"
#include "support/dense.hpp"
#include "support/lattice.hpp"
#include "support/random.hpp"
#include "support/ranks.hpp"

namespace dda {
namespace {

constexpr double rounding = 1e-12;

/// Positive definite, of blocks in rows; with a negative shift it is not.
BlockMatrix lattice(std::size_t columns, std::size_t rows, double shift = 20) {
  const auto pairs = neighbours_in_columns(columns, rows);
  BlockMatrix out(columns * rows, pairs);
  Random random(3);
  for (std::size_t r = 0; r < out.num_rows(); ++r) out.add(BlockId{r}, BlockId{r}, shift * Mat6::Identity());
  for (const auto& [i, j] : pairs) {
    Mat6 m;
    for (int k = 0; k < 36; ++k) m(k) = random.between(-1, 1);
    out.add(i, j, m);
    out.add(j, i, m.transpose());
  }
  return out;
}

/// Two columns at each of two blocks.
SharedMatrix::Entries force(std::size_t one, std::size_t other, Random& random) {
  SharedMatrix::Entries out;
  for (const std::size_t block : {one, other}) {
    Mat62 rows;
    for (int k = 0; k < 12; ++k) rows(k) = random.between(-1, 1);
    out.push_back({BlockId{block}, rows, 0});
  }
  return out;
}

Eigen::MatrixXd written_out(const SharedMatrix::Entries& entries, Eigen::Index n) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, 2);
  for (const auto& entry : entries)
    out.middleRows<6>(6 * static_cast<Eigen::Index>(entry.block.value())) += entry.rows;
  return out;
}

class SharedMatrixTest : public testing::TestWithParam<std::size_t> {
 protected:
  WithRanks ranks_{GetParam()};
  Random random_{17};
};

TEST_P(SharedMatrixTest, SolvesAsOneRankDoes) {
  const BlockMatrix a = lattice(24, 3);
  SharedMatrix shared(ranks_.ranks());
  ASSERT_TRUE(shared.factor(a));
  EXPECT_GT(shared.factor_flops(), 0);
  const Eigen::MatrixXd full = dense(a);
  const std::vector<double> right = random_.vector(static_cast<std::size_t>(3 * full.rows()), 1);
  std::vector<double> x = right;
  shared.solve(x, 3);
  const Eigen::Map<const Eigen::MatrixXd> b(right.data(), full.rows(), 3), found(x.data(), full.rows(), 3);
  EXPECT_LT((full * found - b).norm(), rounding * full.norm() * found.norm());
}

TEST_P(SharedMatrixTest, FactorisesOtherValuesAndOtherPatterns) {
  SharedMatrix shared(ranks_.ranks());
  for (const auto& [columns, shift] : {std::pair<std::size_t, double>{24, 20}, {24, 25}, {5, 20}, {1, 20}}) {
    const BlockMatrix a = lattice(columns, 3, shift);
    ASSERT_TRUE(shared.factor(a));
    const Eigen::MatrixXd full = dense(a);
    std::vector<double> x = random_.vector(static_cast<std::size_t>(full.rows()), 1);
    const Eigen::VectorXd b = Eigen::Map<const Eigen::VectorXd>(x.data(), full.rows());
    shared.solve(x, 1);
    const Eigen::Map<const Eigen::VectorXd> found(x.data(), full.rows());
    EXPECT_LT((full * found - b).norm(), rounding * full.norm() * found.norm()) << columns;
  }
}

TEST_P(SharedMatrixTest, TellsThatAMatrixIsNotDefinite) {
  SharedMatrix shared(ranks_.ranks());
  EXPECT_FALSE(shared.factor(lattice(24, 3, -20)));
  EXPECT_FALSE(shared.factor(lattice(24, 3, 0)));
  EXPECT_TRUE(shared.factor(lattice(24, 3)));
}

/// Groups all over the structure, some of them within a strip, some between two.
TEST_P(SharedMatrixTest, ColumnsAreThoseOfTheInverse) {
  const BlockMatrix a = lattice(24, 3);
  SharedMatrix shared(ranks_.ranks());
  ASSERT_TRUE(shared.factor(a));
  const Eigen::MatrixXd full = dense(a);
  const Eigen::LLT<Eigen::MatrixXd> inverse(full);
  std::vector<SharedMatrix::Entries> groups;
  for (std::size_t block = 0; block + 3 < a.num_rows(); block += 2)
    groups.push_back(force(block, block + 3, random_));
  const auto size = static_cast<Eigen::Index>(2 * groups.size());
  Eigen::MatrixXd u(full.rows(), size), g = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < groups.size(); ++i)
    u.middleCols<2>(2 * static_cast<Eigen::Index>(i)) = written_out(groups[i], full.rows());
  const auto take = [&](std::size_t left, std::size_t right, std::span<const double> product) {
    ASSERT_EQ(product.size(), 4u);
    g.block<2, 2>(2 * static_cast<Eigen::Index>(left), 2 * static_cast<Eigen::Index>(right)) +=
        Eigen::Map<const Eigen::Matrix2d>(product.data());
  };
  const std::span<const SharedMatrix::Entries> all(groups);
  std::vector<BetweenColumns> between = shared.add_groups(all.first(5), take);
  std::ranges::move(shared.add_groups(all.subspan(5), take), std::back_inserter(between));
  for (Eigen::Index i = 0; i < size; i += 2)
    for (Eigen::Index j = i; j < size; j += 2) {
      Between::add_product(between[static_cast<std::size_t>(i / 2)], between[static_cast<std::size_t>(j / 2)],
                           g.block<2, 2>(i, j));
      g.block<2, 2>(j, i) = g.block<2, 2>(i, j).transpose().eval();
    }
  const Eigen::MatrixXd wanted = u.transpose() * inverse.solve(u);
  EXPECT_LT((g - wanted).norm(), rounding * wanted.norm());

  std::vector<SharedMatrix::Multiple> sum;
  Eigen::VectorXd s = Eigen::VectorXd::Zero(size);
  BetweenColumns of_sum = shared.between().zero(0, 1);
  for (const std::size_t group : {std::size_t{1}, std::size_t{7}, groups.size() - 1}) {
    sum.push_back({group, 0, Eigen::Vector2d(random_.point(1))});
    s.segment<2>(2 * static_cast<Eigen::Index>(group)) = sum.back().factors;
    for (std::size_t i = 0; i < between[group].at.size(); ++i)
      of_sum.at[between[group].first + i] += between[group].at[i] * sum.back().factors;
  }
  const std::vector<double> x = shared.complete(std::span(&sum, 1), of_sum);
  const Eigen::VectorXd expected = inverse.solve(u * s);
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(x.data(), full.rows()) - expected).norm(),
            rounding * expected.norm());
}

TEST_P(SharedMatrixTest, CountsWhatEachRankTakes) {
  const BlockMatrix a = lattice(40, 3);
  SharedMatrix shared(ranks_.ranks());
  const std::vector<double> bytes = shared.bytes_by_rank(a);
  ASSERT_EQ(bytes.size(), GetParam());
  for (const double of_rank : bytes) EXPECT_GT(of_rank, 0);
  EXPECT_GT(shared.factor_flops(), 0);
}

INSTANTIATE_TEST_SUITE_P(Ranks, SharedMatrixTest, testing::Values(1, 2, 3, 4));

TEST(SharedMatrix, TellsWhichRankCouldNot) {
  const auto none = [](Message&) -> Message { throw std::runtime_error("not enough memory"); };
  Ranks ranks = Ranks::here({answer_by_parts(), none});
  SharedMatrix shared(ranks);
  EXPECT_THROW(shared.factor(lattice(24, 3)), std::runtime_error);
}

}  // namespace
}  // namespace dda
