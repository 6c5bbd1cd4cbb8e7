#pragma once

#include <suitesparse/cholmod.h>

#include <memory>
#include <span>
#include <vector>

#include "continuation/linear/direct/elimination_order.hpp"
#include "continuation/linear/direct/half_solver.hpp"
#include "models/body/block_matrix.hpp"

namespace dda {

/// Supernodal Cholesky factorisation (CHOLMOD) of a positive definite block matrix on one rank.
///
///     P A Pᵀ = L Lᵀ,     P from the nested dissection of the graph of the blocks
///
/// Half solutions walk the supernodes themselves: CHOLMOD has no product with L⁻¹ that stops where a sparse
/// right-hand side ends. Throws std::runtime_error when the memory does not suffice.
class CholmodMatrix final : public HalfSolver {
 public:
  CholmodMatrix();
  ~CholmodMatrix() override;
  CholmodMatrix(const CholmodMatrix&) = delete;
  CholmodMatrix& operator=(const CholmodMatrix&) = delete;

  /// L of the matrix, analysed before when its pattern is another one than last time. False when a pivot is
  /// not positive, or so small beside its diagonal entry that nothing but rounding is left of it.
  bool factor(const BlockMatrix& a);
  /// Gives the memory of L and A back; what the analysis has found stays.
  void forget();
  /// Overwrites each of the columns of length n in x by the solution for it.
  void solve(std::span<double> x, int columns) const;
  /// Memory of L, known when the matrix is analysed, and of A beside it [bytes].
  double factor_bytes(const BlockMatrix& a);
  /// Operations of the factorisation.
  double factor_flops() const { return common_.fl; }

  HalfSolution half_solve(std::span<const Entry> entries) const override;
  Eigen::MatrixXd product(const HalfSolution& left, const HalfSolution& right) const override;
  void add(const HalfSolution& y, Eigen::Index first, const Eigen::VectorXd& s,
           std::span<double> sum) const override;
  void complete(std::span<double> sums, int columns) const override;

 private:
  /// One supernode of L: `size` columns from `first` on, `rows` of them below one another in `values`.
  struct Supernode {
    int first, size, rows;
    const double* values;
    const int* row;
  };

  void analyse(const BlockMatrix& a);
  /// The upper triangle of A.
  void assemble(const BlockMatrix& a);
  bool has_lost_a_pivot() const;
  void index_supernodes();
  Supernode supernode(int s) const;
  int size_of(int s) const { return super_[s + 1] - super_[s]; }
  /// The supernode above; −1 of a root.
  int parent_of(int s) const;
  /// Entries of L in a supernode.
  double entries_of(int s) const;
  /// Supernodes on the ways from the blocks to the root.
  std::vector<int> way_of(std::span<const BlockId> blocks) const;
  /// The columns of a supernode in L⁻ᵀ x, from all above it.
  void complete_supernode(int s, Eigen::Map<Eigen::MatrixXd>& x) const;
  /// From the order of L to that of the blocks.
  void to_blocks(std::span<double> x) const;
  /// x ← (what CHOLMOD calls) `system` applied to x.
  void apply(int system, std::span<double> x, int columns) const;
  void check(const char* what) const;

  // CHOLMOD takes pointers to all of them in calls that change nothing that counts.
  mutable cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
  cholmod_sparse* matrix_ = nullptr;
  mutable cholmod_dense* work_[3] = {nullptr, nullptr, nullptr};  ///< reused from solve to solve

  std::vector<std::size_t> pattern_rows_, pattern_columns_;  ///< of the matrix that was analysed
  const int* super_ = nullptr;                               ///< first column of each supernode
  std::vector<int> supernode_of_;                            ///< of each column of L
  std::vector<int> position_;                                ///< of each unknown in the order of L
  EliminationOrder whole_;                                   ///< of all supernodes
  mutable std::vector<double> turned_;                       ///< of to_blocks
};

}  // namespace dda
