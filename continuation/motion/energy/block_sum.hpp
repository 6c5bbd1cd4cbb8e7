#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <utility>
#include <vector>

#include "models/kinematics/affine.hpp"

namespace dda {

/// A symmetric matrix of 6 × 6 blocks that is summed up again and again: of its lower triangle those on the diagonal, and
/// those of given pairs.
class BlockSum {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  ///< row, column; row > column
  using Matrix = Eigen::SparseMatrix<double>;

  /// Pairs in any order, and more than once. Whether the pattern is another one than it was.
  bool set_pattern(std::size_t num_rows, std::vector<Pair> pairs);
  std::size_t num_rows() const { return first_.empty() ? 0 : first_.size() - 1; }
  /// Adds those that it has a place for.
  void append_pairs(std::vector<Pair>& out) const;
  /// Whether it has a place for all of these.
  bool covers(const std::vector<Pair>& pairs) const;

  void set_zero();
  /// Block (i, j), and with it (j, i), += m. Only i ≥ j is kept; (i, j) must have a place.
  void add(std::size_t i, std::size_t j, const Mat6& m);
  /// The same with a bᵀ.
  void add(std::size_t i, std::size_t j, const Vec6& a, const Vec6& b);
  /// Its lower triangle; the same pattern as long as set_pattern is not called.
  const Matrix& matrix();

 private:
  static constexpr std::size_t none = -1;

  std::size_t place_of(std::uint32_t row, std::uint32_t column) const;
  Mat6& below(std::size_t row, std::size_t column);

  std::vector<std::size_t> first_;   ///< of each column in rows_
  std::vector<std::uint32_t> rows_;  ///< below the diagonal, growing
  std::vector<Mat6> diagonal_, below_;
  Pair last_ = {};                    ///< that was asked for, most often again and again
  std::size_t place_of_last_ = none;  ///< in below_
  Matrix matrix_;
};

}  // namespace dda
