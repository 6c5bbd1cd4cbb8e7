#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "continuation/modules/loca/dense_vector.hpp"

namespace dda {
namespace {

using Vector = NOX::Abstract::Vector;

DenseVector vector_of(const std::vector<double>& values) {
  DenseVector out(values.size());
  std::ranges::copy(values, out.local().begin());
  return out;
}

std::vector<double> values_of(const Vector& x) {
  const auto entries = local(x);
  return {entries.begin(), entries.end()};
}

TEST(DenseVector, CopiesDeepOrByShape) {
  const DenseVector x = vector_of({1, -2, 3});
  EXPECT_EQ(values_of(DenseVector(x, NOX::DeepCopy)), (std::vector<double>{1, -2, 3}));
  EXPECT_EQ(values_of(DenseVector(x, NOX::ShapeCopy)), (std::vector<double>{0, 0, 0}));
  const auto clone = x.clone(NOX::DeepCopy);
  clone->scale(2);
  EXPECT_EQ(values_of(x), (std::vector<double>{1, -2, 3})) << "a clone is its own";
  EXPECT_EQ(values_of(*clone), (std::vector<double>{2, -4, 6}));
}

TEST(DenseVector, Arithmetic) {
  DenseVector x = vector_of({1, -2, 4});
  const DenseVector y = vector_of({3, 5, 7});
  x.update(2, static_cast<const Vector&>(y), -1);
  EXPECT_EQ(values_of(x), (std::vector<double>{5, 12, 10}));
  x.update(1, static_cast<const Vector&>(y), 2, static_cast<const Vector&>(y), 1);
  EXPECT_EQ(values_of(x), (std::vector<double>{14, 27, 31}));
  x.scale(static_cast<const Vector&>(y));
  EXPECT_EQ(values_of(x), (std::vector<double>{42, 135, 217}));
  x.abs(static_cast<const Vector&>(vector_of({-1, 2, -4})));
  EXPECT_EQ(values_of(x), (std::vector<double>{1, 2, 4}));
  x.reciprocal(static_cast<const Vector&>(vector_of({2, 4, 8})));
  EXPECT_EQ(values_of(x), (std::vector<double>{0.5, 0.25, 0.125}));
  x.init(7);
  EXPECT_EQ(values_of(x), (std::vector<double>{7, 7, 7}));
}

TEST(DenseVector, Norms) {
  const DenseVector x = vector_of({3, -4, 0}), y = vector_of({1, 2, 5});
  EXPECT_EQ(x.norm(Vector::TwoNorm), 5);
  EXPECT_EQ(x.norm(Vector::OneNorm), 7);
  EXPECT_EQ(x.norm(Vector::MaxNorm), 4);
  EXPECT_EQ(x.innerProduct(y), -5);
  EXPECT_DOUBLE_EQ(x.norm(y), std::sqrt(9.0 + 32.0));
  EXPECT_EQ(x.length(), 3);
}

TEST(DenseVector, TakesTheLengthOfWhatIsAssigned) {
  DenseVector x = vector_of({1, 2});
  const DenseVector longer = vector_of({3, 4, 5});
  EXPECT_EQ(x.innerProduct(longer), 11) << "entries that one lacks are zero";
  x.update(1, static_cast<const Vector&>(longer), 1);
  EXPECT_EQ(values_of(x), (std::vector<double>{4, 6, 5}));
  x = static_cast<const Vector&>(vector_of({9}));
  EXPECT_EQ(values_of(x), (std::vector<double>{9}));
  x.update(2, static_cast<const Vector&>(longer), 1, static_cast<const Vector&>(vector_of({1})), 0);
  EXPECT_EQ(values_of(x), (std::vector<double>{7, 8, 10}));
}

}  // namespace
}  // namespace dda
