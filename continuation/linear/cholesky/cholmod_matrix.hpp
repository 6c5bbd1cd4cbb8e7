#pragma once

#include <suitesparse/cholmod.h>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "continuation/linear/cholesky/elimination_order.hpp"
#include "continuation/linear/cholesky/half_solver.hpp"
#include "models/body/block_matrix.hpp"

namespace dda {

/// Supernodal Cholesky factorisation (CHOLMOD) of a positive definite block matrix on one rank.
///
///     P A Pᵀ = L Lᵀ,     P from the nested dissection of the graph of the blocks
///
/// The last rows may be a border, whose rows of L come last and in their order. Half solutions end before it, and leave
/// what of their right-hand sides is for others to go on with:
///
///     A = [ A_I  A_IB ; A_BI  A_B ],     y = L_I⁻¹ u_I,     rest = u_B − L_BI y,     L_B L_Bᵀ = A_B − L_BI L_BIᵀ
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
  bool factor(const BlockMatrix& a) { return factor(a, 0); }
  /// The same with a border of so many blocks, fewer than all.
  bool factor(const BlockMatrix& a, std::size_t border);
  /// Gives the memory of L and A back; what the analysis has found stays.
  void forget();
  /// Overwrites each of the columns of length n in x by the solution for it.
  void solve(std::span<double> x, int columns) const;
  /// Memory of L, known when the matrix is analysed, and of A beside it [bytes].
  double factor_bytes(const BlockMatrix& a) { return factor_bytes(a, 0); }
  double factor_bytes(const BlockMatrix& a, std::size_t border);
  /// Operations of the factorisation.
  double factor_flops() const { return common_.fl; }

  HalfSolution half_solve(std::span<const Entry> entries) const override;
  /// The same with a border; entries in its blocks are left out. May be called by several threads.
  HalfSolution half_solve(std::span<const Entry> entries, Eigen::MatrixXd& rest) const;
  Eigen::MatrixXd product(const HalfSolution& left, const HalfSolution& right) const override;
  void add(const HalfSolution& y, Eigen::Index first, const Eigen::VectorXd& s,
           std::span<double> sum) const override;
  /// With a border the last rows are the solution there.
  void complete(std::span<double> sums, int columns) const override;
  /// Overwrites each of the columns in x, in the order of the blocks, by y in the order of L, and by the rest.
  void begin(std::span<double> x, int columns) const;
  /// L_B L_Bᵀ − A_B, its lower triangle column by column; what is not needed any more is forgotten.
  std::vector<double> border_update();
  std::size_t num_border_rows() const { return factor_->n - eliminated_; }

 private:
  /// One supernode of L: `size` columns from `first` on, `rows` of them below one another in `values`.
  struct Supernode {
    int first, size, rows;
    const double* values;
    const int* row;
  };

  void analyse(const BlockMatrix& a);
  /// Blocks of A_I in the order of nested dissection, unknown by unknown.
  std::vector<int> dissected(const BlockMatrix& a);
  /// The same as the elimination tree has them, children before their parents and branch by branch.
  std::vector<int> along_the_tree(std::vector<int> order);
  /// From the order of the blocks to that of L.
  void to_factor(std::span<double> x) const;
  /// The upper triangle of A.
  void assemble(const BlockMatrix& a);
  bool has_lost_a_pivot() const;
  void index_supernodes();
  Supernode supernode(int s) const;
  /// Columns of a supernode that are eliminated.
  int size_of(int s) const { return std::min(super_[s + 1], static_cast<int>(eliminated_)) - super_[s]; }
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
  std::size_t border_ = 0;                                   ///< blocks of the border
  std::size_t eliminated_ = 0;                               ///< rows of A_I
  const int* super_ = nullptr;                               ///< first column of each supernode
  std::vector<int> supernode_of_;                            ///< of each column of L
  std::vector<int> position_;                                ///< of each unknown in the order of L
  EliminationOrder whole_;                                   ///< of all supernodes
  mutable std::vector<double> turned_;                       ///< of to_blocks
};

}  // namespace dda
