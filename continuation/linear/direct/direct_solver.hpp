#pragma once

#include <memory>
#include <span>

#include "framework/deck/family.hpp"
#include "models/body/block_matrix.hpp"

namespace dda {

class HalfSolver;

/// A sparse direct solver of symmetric matrices, possibly indefinite.
class DirectSolver {
 public:
  virtual ~DirectSolver() = default;
  /// Factorises A; the pattern may be another one than last time. False when A is numerically singular.
  virtual bool factor(const BlockMatrix& a) = 0;
  /// Overwrites each of the columns of length n in x by A⁻¹ times it.
  virtual void solve(std::span<double> x, int columns) = 0;
  /// Memory that a factorisation of A takes at least, from its pattern alone [bytes].
  virtual double factor_bytes(const BlockMatrix& a) = 0;
  /// Estimated floating point operations of the last factorisation, or of the one that `factor_bytes`
  /// counted.
  virtual double factor_flops() const = 0;
  /// Number of negative eigenvalues of A, or −1 when the solver does not tell.
  virtual int num_negative_pivots() const = 0;
  /// Half solutions of the last factorisation; null where it has none.
  virtual const HalfSolver* halves() const { return nullptr; }
};

using DirectSolverFamily = Family<DirectSolver>;
using DirectSolverChoice = Choice<DirectSolver>;

/// The registry of linear solvers.
DirectSolverFamily& direct_solvers();

}  // namespace dda
