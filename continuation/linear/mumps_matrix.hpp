#pragma once

#include <dmumps_c.h>

#include <span>
#include <vector>

#include "models/block_matrix.hpp"

namespace dda {

/// An instance of MUMPS for symmetric, possibly indefinite matrices (sym = 2) of one rank, with its matrix.
///
/// Controls and results have the numbers of MUMPS' users' guide: `control(24)` is ICNTL(24), `count(12)` is
/// INFOG(12). Must not outlive the MPI session.
class MumpsMatrix {
 public:
  MumpsMatrix();
  ~MumpsMatrix();
  MumpsMatrix(const MumpsMatrix&) = delete;
  MumpsMatrix& operator=(const MumpsMatrix&) = delete;

  /// Takes the lower triangle of A; the pattern may be another one than last time.
  void set(const BlockMatrix& a);
  /// LDLᵀ of the matrix, analysed before when its pattern is new. False when it is numerically singular.
  bool factor();
  /// Overwrites each of the columns of length n in x by the solution for it. Throws std::runtime_error.
  void solve(std::span<double> x, int columns);

  MUMPS_INT& control(int number) { return id_.icntl[number - 1]; }         ///< ICNTL
  double& real_control(int number) { return id_.cntl[number - 1]; }        ///< CNTL
  int count(int number) const { return id_.infog[number - 1]; }            ///< INFOG
  double real_result(int number) const { return id_.rinfog[number - 1]; }  ///< RINFOG

 private:
  /// Enlarges the workspace when MUMPS asks for it; false when the matrix is singular.
  bool call(int job);

  DMUMPS_STRUC_C id_{};
  std::vector<MUMPS_INT> rows_, columns_;
  std::vector<double> values_;
  bool is_analysed_ = false;
};

}  // namespace dda
