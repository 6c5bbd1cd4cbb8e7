#include "continuation/stability/eigenmodes.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "continuation/stability/krylov_schur.hpp"

namespace dda {
namespace {

using Vector = Eigen::Map<const Eigen::VectorXd>;

/// Pairs in ascending order of μ, the first `count` of them.
Eigenmodes lowest_of(const Eigenmodes& found, int count) {
  std::vector<std::size_t> order(found.values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return found.values[i]; });
  Eigenmodes out;
  for (const std::size_t i : order) {
    if (static_cast<int>(out.values.size()) == count) break;
    out.values.push_back(found.values[i]);
    out.shapes.push_back(found.shapes[i]);
  }
  return out;
}

/// The `count` lowest pairs, which lie beyond those found nearest to zero.
Eigenmodes lowest_by_shift(const EigenProblem& problem, const Eigenmodes& nearest, int count) {
  double shift = 0;
  for (const double value : nearest.values) shift = std::max(shift, 2 * std::abs(value));
  constexpr double growth = 4;
  constexpr int most_shifts = 40;
  for (int i = 0; i < most_shifts; ++i, shift *= growth)
    if (const InverseOperator solve = problem.shifted(shift))
      return krylov_schur(problem, {solve, shift, count});
  throw std::runtime_error("no shift makes the stiffness positive definite");
}

Eigenmodes dense_eigenmodes(const EigenProblem& problem, const InverseOperator& solve, double shift) {
  const auto n = static_cast<Eigen::Index>(problem.n());
  Eigen::MatrixXd inverse(n, n);
  std::vector<double> unit(problem.n(), 0.0), column(problem.n());
  for (Eigen::Index i = 0; i < n; ++i) {
    unit[static_cast<std::size_t>(i)] = 1;
    solve(unit, column);
    unit[static_cast<std::size_t>(i)] = 0;
    inverse.col(i) = Vector(column.data(), n);
  }
  const Eigen::MatrixXd root = problem.mass.dense().llt().matrixL();
  // M = R Rᵀ: Rᵀ (K + s M)⁻¹ R x = ν x is symmetric, and φ = R⁻ᵀ x.
  const Eigen::MatrixXd reduced = root.transpose() * inverse * root;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> own(0.5 * (reduced + reduced.transpose()));
  Eigenmodes all;
  // Of stiffer modes nothing but rounding is left in K⁻¹.
  const double rounding = 1e-14 * own.eigenvalues().cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < n; ++i) {
    if (std::abs(own.eigenvalues()[i]) <= rounding) continue;
    const Eigen::VectorXd shape =
        root.triangularView<Eigen::Lower>().transpose().solve(own.eigenvectors().col(i));
    all.values.push_back(1 / own.eigenvalues()[i] - shift);
    all.shapes.emplace_back(shape.data(), shape.data() + n);
  }
  return lowest_of(all, problem.count);
}

/// The pairs nearest to −s.
Eigenmodes nearest(const EigenProblem& problem, const InverseOperator& solve, double shift) {
  return problem.n() <= dense_below ? dense_eigenmodes(problem, solve, shift)
                                    : krylov_schur(problem, {solve, shift, problem.count});
}

/// Whether some of the pairs are so much softer than others that K⁻¹ leaves these few digits.
bool is_ill_scaled(const Eigenmodes& found) {
  constexpr double few = 1e-6;
  double softest = std::numeric_limits<double>::infinity(), stiffest = 0;
  for (const double value : found.values) {
    softest = std::min(softest, std::abs(value));
    stiffest = std::max(stiffest, std::abs(value));
  }
  return softest < few * stiffest;
}

/// Modes that only weak springs oppose, by a shift that is small for all others.
Eigenmodes with_rigid_modes(const EigenProblem& problem, Eigenmodes found) {
  constexpr double small = 1e-3;
  double stiffest = 0;
  for (const double value : found.values) stiffest = std::max(stiffest, std::abs(value));
  const InverseOperator solve = problem.shifted ? problem.shifted(small * stiffest) : InverseOperator{};
  return solve ? nearest(problem, solve, small * stiffest) : found;
}

}  // namespace

Eigenmodes dense_eigenmodes(const EigenProblem& problem) {
  return dense_eigenmodes(problem, problem.solve, 0);
}

Eigenmodes lowest_eigenmodes(const EigenProblem& problem) {
  Eigenmodes found = nearest(problem, problem.solve, 0);
  if (is_ill_scaled(found)) found = with_rigid_modes(problem, std::move(found));
  if (problem.n() <= dense_below) return found;
  const auto negative = std::ranges::count_if(found.values, [](double value) { return value < 0; });
  if (const auto missing = problem.num_negative.value_or(0) - negative; missing > 0) {
    const Eigenmodes far = lowest_by_shift(problem, found, static_cast<int>(missing));
    found.values.insert(found.values.end(), far.values.begin(), far.values.end());
    found.shapes.insert(found.shapes.end(), far.shapes.begin(), far.shapes.end());
  }
  return lowest_of(found, problem.count);
}

double modal_assurance(std::span<const double> a, std::span<const double> b, const Mass& mass) {
  const auto n = static_cast<Eigen::Index>(block_unknowns * mass.num_nodes());
  std::vector<double> moved(static_cast<std::size_t>(n));
  mass.multiply(b, moved);
  const double sum = Vector(a.data(), n).dot(Vector(moved.data(), n));
  return sum * sum;
}

}  // namespace dda
