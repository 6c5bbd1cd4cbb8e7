#pragma once

#include <dmumps_c.h>

#include <span>
#include <vector>

#include "models/body/block_matrix.hpp"

namespace dda {

/// An instance of MUMPS of one rank, with its matrix: symmetric and possibly indefinite (sym = 2), or
/// unsymmetric with a symmetric pattern (sym = 0).
///
/// Controls and results have the numbers of MUMPS' users' guide: `control(24)` is ICNTL(24), `count(12)` is
/// INFOG(12). Must not outlive the MPI session.
class MumpsMatrix {
 public:
  enum class Symmetry { none = 0, general = 2 };

  explicit MumpsMatrix(Symmetry symmetry = Symmetry::general);
  ~MumpsMatrix();
  MumpsMatrix(const MumpsMatrix&) = delete;
  MumpsMatrix& operator=(const MumpsMatrix&) = delete;

  /// Takes A, its lower triangle if it is symmetric; the pattern may be another one than last time.
  ///
  /// Multipliers are eliminated after the blocks they tie: a tie contributes P to the blocks' part and δ P to
  /// its own, so that both stay definite and no pivot has to wait. In an ordering that knows nothing of it
  /// the redundant multipliers of bonded polygons do, by the thousand. Pivots δ P cost digits: solutions are
  /// refined.
  void set(const BlockMatrix& a);
  /// LDLᵀ or LU of the matrix, analysed before when its pattern is new. False when it is numerically
  /// singular.
  bool factor();
  /// Memory of the factors that the analysis expects, and of the copy of A [bytes].
  double factor_bytes(const BlockMatrix& a);
  /// Operations of the factorisation; before the first those that the analysis expects.
  double flops() const { return is_factorised_ ? real_result(3) : real_result(1); }
  /// Overwrites each of the columns of length n in x by the solution for it. Throws std::runtime_error.
  void solve(std::span<double> x, int columns);

  MUMPS_INT& control(int number) { return id_.icntl[number - 1]; }   ///< ICNTL
  double& real_control(int number) { return id_.cntl[number - 1]; }  ///< CNTL
  int count(int number) const { return id_.infog[number - 1]; }      ///< INFOG
  /// INFOG of numbers that it gives in millions where they are large, negative then.
  double large_count(int number) const {
    constexpr double million = 1e6;
    return count(number) < 0 ? -million * count(number) : count(number);
  }
  double real_result(int number) const { return id_.rinfog[number - 1]; }  ///< RINFOG

 private:
  bool is_symmetric() const { return id_.sym != 0; }
  /// Enlarges the workspace when MUMPS asks for it; false when the matrix is singular.
  bool call(int job);
  void point_at(std::size_t n);
  /// One forward and backward substitution.
  void substitute(std::span<double> x, int columns);
  /// y −= A x.
  void subtract_product(const double* x, double* y) const;
  void order_multipliers_last(const BlockMatrix& a);
  /// Position of each of A's rows in that elimination.
  static std::vector<std::size_t> elimination_of(const BlockMatrix& a);

  DMUMPS_STRUC_C id_{};
  std::vector<MUMPS_INT> rows_, columns_, position_;
  std::vector<double> values_;
  bool is_analysed_ = false, is_factorised_ = false;
};

}  // namespace dda
