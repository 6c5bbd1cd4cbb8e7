#include "continuation/linear/matrix_quality.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "continuation/linear/direct/mumps_matrix.hpp"

namespace dda {
namespace {

using Vector = Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Calls f(row, column, block) for every stored block.
template <class F>
void for_each_block(const BlockMatrix& a, F&& f) {
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s)
      f(BlockId{r}, BlockId{a.columns()[s]}, a.value(s));
}

/// S that gives Â = S A S a unit diagonal, or rows of unit size where the diagonal is nothing but rounding,
/// as that of an exact multiplier.
std::vector<Vec6> unit_scale(const BlockMatrix& a) {
  std::vector<Vec6> diagonal(a.num_rows()), largest(a.num_rows(), Vec6::Zero());
  for_each_block(a, [&](BlockId i, BlockId j, const Mat6& m) {
    if (i == j) diagonal[i.value()] = m.diagonal().cwiseAbs();
  });
  std::vector<Vec6> scale(a.num_rows());
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    scale[r] = (diagonal[r].array() > 0).select(diagonal[r].cwiseSqrt().cwiseInverse(), 1.0);
  if (a.num_leading() == a.num_rows()) return scale;
  for_each_block(a, [&](BlockId i, BlockId j, const Mat6& m) {
    if (j.value() < a.num_leading())
      largest[i.value()] =
          largest[i.value()].cwiseMax((m * scale[j.value()].asDiagonal()).cwiseAbs().rowwise().maxCoeff());
  });
  constexpr double rounding = 1e-12;
  for (std::size_t r = a.num_leading(); r < a.num_rows(); ++r)
    for (int k = 0; k < block_unknowns; ++k)
      if (const double row = largest[r][k]; diagonal[r][k] <= rounding * row * row) scale[r][k] = 1 / row;
  return scale;
}

/// Â = S A S.
BlockMatrix scaled(const BlockMatrix& a) {
  std::vector<std::pair<BlockId, BlockId>> pairs;
  const std::vector<Vec6> scale = unit_scale(a);
  for_each_block(a, [&](BlockId i, BlockId j, const Mat6&) { pairs.emplace_back(i, j); });
  BlockMatrix out(a.num_rows(), std::move(pairs), a.num_leading());
  for_each_block(a, [&](BlockId i, BlockId j, const Mat6& m) {
    out.add(i, j, scale[i.value()].asDiagonal() * m * scale[j.value()].asDiagonal());
  });
  return out;
}

BlockMatrix shifted(BlockMatrix a, double shift) {
  for (std::size_t r = 0; r < a.num_rows(); ++r) a.add(BlockId{r}, BlockId{r}, shift * Mat6::Identity());
  return a;
}

/// ‖A‖₁, the largest sum of magnitudes in a column: the same as in a row.
double norm(const BlockMatrix& a) {
  std::vector<Vec6> sums(a.num_rows(), Vec6::Zero());
  for_each_block(a,
                 [&](BlockId i, BlockId, const Mat6& m) { sums[i.value()] += m.cwiseAbs().rowwise().sum(); });
  double largest = 0;
  for (const Vec6& sum : sums) largest = std::max(largest, sum.maxCoeff());
  return largest;
}

int negative_eigenvalues(MumpsMatrix& matrix, const BlockMatrix& a) {
  matrix.set(a);
  matrix.factor();
  return matrix.count(12);
}

Vector solved(MumpsMatrix& matrix, Vector right) {
  matrix.solve({right.data(), static_cast<std::size_t>(right.size())}, 1);
  return right;
}

/// Hager's ascent of the convex function x → ‖A⁻¹ x‖₁, ‖x‖₁ ≤ 1, from corner to corner of its domain.
double ascent(MumpsMatrix& matrix, const Vector& start) {
  constexpr int most_corners = 5;
  Vector image = solved(matrix, start);
  double height = image.lpNorm<1>();
  for (int corner = 0; corner < most_corners; ++corner) {
    const Vector signs = image.unaryExpr([](double value) { return value < 0 ? -1.0 : 1.0; });
    Eigen::Index steepest = 0;
    solved(matrix, signs).cwiseAbs().maxCoeff(&steepest);
    image = solved(matrix, Vector::Unit(signs.size(), steepest));
    const double reached = image.lpNorm<1>();
    if (reached <= height) break;
    height = reached;
  }
  return height;
}

/// ‖A⁻¹‖₁ from below. From equal numbers alone the ascent may stay among unknowns that do not see the soft
/// ones; Higham's numbers of alternating sign and growing size are the second start.
double inverse_norm(MumpsMatrix& matrix, std::size_t size) {
  const auto n = static_cast<Eigen::Index>(size);
  Vector alternating = Vector::LinSpaced(n, 1, 2);
  for (Eigen::Index i = 1; i < n; i += 2) alternating[i] = -alternating[i];
  return std::max(ascent(matrix, Vector::Constant(n, 1.0 / static_cast<double>(n))),
                  ascent(matrix, alternating / alternating.lpNorm<1>()));
}

}  // namespace

int num_redundant(const BlockMatrix& a) {
  const BlockMatrix unit = scaled(a);
  const double null = 1e-13 * norm(unit);
  MumpsMatrix matrix;
  matrix.control(8) = 0;
  const int negative = negative_eigenvalues(matrix, shifted(unit, null));
  return negative_eigenvalues(matrix, shifted(unit, -null)) - negative;
}

MatrixQuality assess(const BlockMatrix& a) {
  const BlockMatrix unit = scaled(a);
  const double size = norm(unit), null = 1e-13 * size;
  MumpsMatrix matrix;
  matrix.control(8) = 0;                     // MUMPS' own scaling would hide the pivots of Â
  matrix.control(24) = 1;                    // null pivots are passed over
  matrix.real_control(3) = -epsilon * size;  // negative: absolute
  MatrixQuality out;
  out.negative_pivots = negative_eigenvalues(matrix, shifted(unit, null));
  out.null_pivots = negative_eigenvalues(matrix, shifted(unit, -null)) - out.negative_pivots;
  matrix.set(unit);
  matrix.factor();
  out.smallest_pivot = matrix.real_result(20);
  out.largest_pivot = matrix.real_result(21);
  const bool is_singular = matrix.count(28) > 0;
  out.condition = is_singular ? 1 / epsilon : size * inverse_norm(matrix, 6 * a.num_rows());
  if (!(out.condition < 1 / epsilon)) out.condition = std::numeric_limits<double>::infinity();
  return out;
}

}  // namespace dda
