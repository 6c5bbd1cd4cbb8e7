#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "framework/base/index.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// Half of the solutions of A z = u for a few right-hand sides with few entries: y = L⁻¹ u, A = L Lᵀ.
///
/// y differs from zero only along the way from the blocks of u to the root of the elimination tree, some
/// thousand numbers where z has all n.
struct HalfSolution {
  std::vector<int> parts;      ///< groups of rows of L on that way, ascending
  std::vector<double> values;  ///< rows of the parts, one after another, each with its columns
  Eigen::Index columns = 0;
};

/// What a Cholesky factorisation A = L Lᵀ of n rows gives for half of the price of a solution, or less.
class HalfSolver {
 public:
  /// The rows of a block in two right-hand sides, 2 · pair and the next.
  struct Entry {
    BlockId block;
    Mat62 rows;
    Eigen::Index pair = 0;
  };

  virtual ~HalfSolver() = default;
  /// L⁻¹ u of the right-hand sides with these entries. May be called by several threads.
  virtual HalfSolution half_solve(std::span<const Entry> entries) const = 0;
  /// yᵀ y' = uᵀ A⁻¹ u'. May be called by several threads.
  virtual Eigen::MatrixXd product(const HalfSolution& left, const HalfSolution& right) const = 0;
  /// sum += y s, with the columns of y from `first` on and the sum of size n in the order of L.
  virtual void add(const HalfSolution& y, Eigen::Index first, const Eigen::VectorXd& s,
                   std::span<double> sum) const = 0;
  /// Overwrites each column of a sum Σ y s by A⁻¹ Σ u s.
  virtual void complete(std::span<double> sums, int columns) const = 0;
};

}  // namespace dda
