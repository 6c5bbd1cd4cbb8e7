#pragma once

#include <Eigen/Core>
#include <vector>

namespace dda {

/// Some right-hand sides or solutions in what lies between strips: a matrix for each place, from one on. Before it
/// right-hand sides are zero.
struct BetweenColumns {
  std::size_t first = 0;
  std::vector<Eigen::MatrixXd> at;
};

/// What is left of a structure in strips (strips.hpp) when these are eliminated: S, block tridiagonal,
///
///     S = K_B + Σ S_B = L Lᵀ
///
/// with a dense block for what lies between two strips, and one beside it for the next.
class Between {
 public:
  /// S = 0, with so many rows in each block.
  void begin(const std::vector<std::size_t>& rows);
  /// Adds S_B of a strip, its lower triangle column by column: rows of what lies before it, then behind it.
  void add_strip(std::size_t strip, const std::vector<double>& lower);
  /// Block on the diagonal, its lower triangle counts.
  Eigen::MatrixXd& diagonal(std::size_t place) { return diagonal_[place]; }
  /// L instead of S. False where S is not positive definite.
  bool factor();
  double factor_flops() const;
  /// Bytes of S.
  double bytes() const;

  std::size_t size() const { return diagonal_.size(); }
  std::size_t num_rows(std::size_t place) const { return static_cast<std::size_t>(diagonal_[place].rows()); }
  /// Zero right-hand sides, from a place on.
  BetweenColumns zero(std::size_t first, Eigen::Index columns) const;
  /// b ← L⁻¹ b. May be called by several threads, column by column with the same digits.
  void half_solve(BetweenColumns& b) const;
  /// y ← L⁻ᵀ y; it begins with the first place then.
  void complete(BetweenColumns& y) const;
  /// out += xᵀ y.
  static void add_product(const BetweenColumns& x, const BetweenColumns& y, Eigen::Ref<Eigen::MatrixXd> out);

 private:
  std::vector<Eigen::MatrixXd> diagonal_;
  std::vector<Eigen::MatrixXd> below_;  ///< rows of the next place
};

}  // namespace dda
