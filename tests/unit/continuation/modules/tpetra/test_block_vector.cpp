#include <gtest/gtest.h>

#include <cmath>

#include "continuation/modules/tpetra/block_vector.hpp"
#include "continuation/modules/trilinos_session.hpp"

namespace dda {
namespace {

BlockVector vector_of(const std::vector<double>& values) {
  BlockVector out(Teuchos::rcp(new TpetraMap(values.size(), 0, this_rank())));
  std::copy(values.begin(), values.end(), out.local().begin());
  return BlockVector(out, NOX::DeepCopy);
}

std::vector<double> values_of(const BlockVector& x) { return {x.local().begin(), x.local().end()}; }

class BlockVectorTest : public testing::Test {
  TrilinosSession session_;
};

TEST_F(BlockVectorTest, CopiesDeepOrByShape) {
  const BlockVector x = vector_of({1, -2, 3});
  EXPECT_EQ(values_of(BlockVector(x, NOX::DeepCopy)), (std::vector<double>{1, -2, 3}));
  EXPECT_EQ(values_of(BlockVector(x, NOX::ShapeCopy)), (std::vector<double>{0, 0, 0}));
  const auto clone = x.clone(NOX::DeepCopy);
  clone->scale(2);
  EXPECT_EQ(values_of(x), (std::vector<double>{1, -2, 3})) << "a clone is its own";
  EXPECT_EQ(values_of(dynamic_cast<const BlockVector&>(*clone)), (std::vector<double>{2, -4, 6}));
}

TEST_F(BlockVectorTest, Arithmetic) {
  BlockVector x = vector_of({1, -2, 4});
  const BlockVector y = vector_of({3, 5, 7});
  x.update(2, static_cast<const NOX::Abstract::Vector&>(y), -1);
  EXPECT_EQ(values_of(x), (std::vector<double>{5, 12, 10}));
  x.update(1, static_cast<const NOX::Abstract::Vector&>(y), 2, static_cast<const NOX::Abstract::Vector&>(y),
           1);
  EXPECT_EQ(values_of(x), (std::vector<double>{14, 27, 31}));
  x.scale(static_cast<const NOX::Abstract::Vector&>(y));
  EXPECT_EQ(values_of(x), (std::vector<double>{42, 135, 217}));
  x.abs(static_cast<const NOX::Abstract::Vector&>(vector_of({-1, 2, -4})));
  EXPECT_EQ(values_of(x), (std::vector<double>{1, 2, 4}));
  x.reciprocal(static_cast<const NOX::Abstract::Vector&>(vector_of({2, 4, 8})));
  EXPECT_EQ(values_of(x), (std::vector<double>{0.5, 0.25, 0.125}));
  x.init(7);
  EXPECT_EQ(values_of(x), (std::vector<double>{7, 7, 7}));
}

TEST_F(BlockVectorTest, Norms) {
  const BlockVector x = vector_of({3, -4, 0}), y = vector_of({1, 2, 5});
  EXPECT_EQ(x.norm(NOX::Abstract::Vector::TwoNorm), 5);
  EXPECT_EQ(x.norm(NOX::Abstract::Vector::OneNorm), 7);
  EXPECT_EQ(x.norm(NOX::Abstract::Vector::MaxNorm), 4);
  EXPECT_EQ(x.innerProduct(y), -5);
  EXPECT_DOUBLE_EQ(x.norm(y), std::sqrt(9.0 + 32.0));
  EXPECT_EQ(x.length(), 3);
}

}  // namespace
}  // namespace dda
