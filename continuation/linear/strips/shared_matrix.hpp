#pragma once

#include <Eigen/Core>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

#include "continuation/linear/cholesky/half_solver.hpp"
#include "continuation/linear/strips/between.hpp"
#include "continuation/linear/strips/strip_part.hpp"
#include "continuation/linear/strips/strips.hpp"
#include "models/body/block_matrix.hpp"

namespace dda {

/// Of a block, in a vector of all.
inline Eigen::Index first_row_of(std::size_t block) {
  return block_unknowns * static_cast<Eigen::Index>(block);
}

/// A positive definite matrix whose Cholesky factorisation, solutions and half solutions are shared by the ranks of a
/// run: each has a strip of the structure (strips.hpp, strip_part.hpp), rank 0 what lies between them as well.
///
///     A = L Lᵀ,     L⁻¹ u = y_I of each strip, and y_B = L_B⁻¹ (u_B + Σ rest)
///
/// All that is added comes in the order of the ranks: results are the same bits each time for the same number of
/// them. Rank 0, which has the model as well, takes 2/N² of N ranks' blocks. Throws std::runtime_error with the
/// rank that could not do its part.
///
/// The ranks keep half solutions, in groups, and are asked for many at once (`add_groups`). One at a time (HalfSolver),
/// one after another, costs a message each; L has the rows of the strips, then those between.
class SharedMatrix final : public HalfSolver {
 public:
  using Entries = std::vector<Entry>;
  /// Takes the product of the half solutions of two groups on a rank, column by column.
  using TakeProduct =
      std::function<void(std::size_t left, std::size_t right, std::span<const double> product)>;
  /// Some columns of a group, from one on, times numbers.
  struct Multiple {
    std::size_t group;
    Eigen::Index column;
    Eigen::VectorXd factors;
  };

  explicit SharedMatrix(Ranks& ranks);
  ~SharedMatrix() override;
  SharedMatrix(const SharedMatrix&) = delete;
  SharedMatrix& operator=(const SharedMatrix&) = delete;

  /// False when the matrix, or what is left of it between the strips, is not positive definite.
  bool factor(const BlockMatrix& a);
  /// Gives the memory of L back on all ranks.
  void forget();
  /// Overwrites each of the columns of length n in x by the solution for it.
  void solve(std::span<double> x, int columns);
  /// Memory of each rank's part of L and A, that between strips with rank 0 [bytes]. Nothing is factorised.
  std::vector<double> bytes_by_rank(const BlockMatrix& a);
  /// The same of the ranks on this machine together.
  double bytes_here(const BlockMatrix& a);
  /// Operations of all ranks; known when the matrix is counted or factorised.
  double factor_flops() const { return flops_; }

  /// Half solutions of more groups, numbered on from those before, which the ranks keep: their rows between the
  /// strips, and their products with all groups up to them in the strips.
  std::vector<BetweenColumns> add_groups(std::span<const Entries> groups, const TakeProduct& take) const {
    return add_groups(groups, &take);
  }
  void forget_groups() const;
  /// A⁻¹ Σ u s of the groups' right-hand sides u, for each sum, from the same sum of rows between the strips.
  std::vector<double> complete(std::span<const std::vector<Multiple>> sums, BetweenColumns between) const;
  /// Of one right-hand side, column 0 of the entries: rows between the strips; products with all groups in the strips.
  BetweenColumns along(const Entries& entries, const TakeProduct& take) const;

  HalfSolution half_solve(std::span<const Entry> entries) const override;
  Eigen::MatrixXd product(const HalfSolution& left, const HalfSolution& right) const override;
  void add(const HalfSolution& y, Eigen::Index first, const Eigen::VectorXd& s,
           std::span<double> sum) const override;
  void complete(std::span<double> sums, int columns) const override;

  const Between& between() const { return between_; }
  std::size_t num_rows() const { return block_unknowns * place_.size(); }

 private:
  /// Where a block is: in a strip, or between two.
  struct Place {
    bool is_between;
    std::size_t of, index;
  };

  void divide(const BlockMatrix& a);
  std::vector<BetweenColumns> add_groups(std::span<const Entries> groups, const TakeProduct* take) const;
  BetweenColumns between_of(const HalfSolution& y) const;
  bool holds(std::size_t strip, std::size_t group) const;
  /// Rows of L before a strip, or of all strips.
  std::size_t first_row(std::size_t strip) const;
  /// What the ranks with a strip are asked for: the order, the number of this matrix, and what more is put into it.
  Message request_for(Order order) const;
  std::size_t num_strips() const { return strips_.strips.size(); }
  std::size_t first_beside(const Entries& entries) const;
  /// Those in a strip, with its numbers of blocks.
  Entries entries_in(const Entries& entries, std::size_t strip) const;
  void add_entries(const Entries& entries, BetweenColumns& to) const;
  /// Adds what a strip leaves, rows of its border column by column.
  void add_rest(std::size_t strip, std::span<const double> rest, BetweenColumns& to) const;
  /// Solutions in the border of a strip.
  std::vector<double> border_values(std::size_t strip, const BetweenColumns& x) const;
  void scatter(std::size_t strip, std::span<const double> x, std::span<double> to) const;
  void scatter(const BetweenColumns& x, std::span<double> to) const;

  Ranks& ranks_;
  const int name_;
  std::vector<std::size_t> pattern_rows_, pattern_columns_;  ///< of the matrix that was divided
  Strips strips_;
  std::vector<Place> place_;  ///< of each block
  Between between_;
  double flops_ = 0;
  mutable std::vector<std::vector<std::size_t>> held_;  ///< groups with something in each strip
  mutable std::vector<Eigen::Index> columns_;           ///< of each group
  mutable std::mutex one_at_a_time_;
};

}  // namespace dda
