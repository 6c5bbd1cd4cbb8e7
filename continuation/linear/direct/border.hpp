#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "continuation/linear/cholesky/half_solver.hpp"
#include "models/body/block_matrix.hpp"

namespace dda {

class DirectSolver;

/// Nodes that have come behind those of a factorised matrix:
///
///     K = [ A  B ; Bᵀ C ],     S = C − Bᵀ A⁻¹ B = L J Lᵀ,     J = ±1 on the diagonal
///
/// L is grown node by node, 6 unknowns each, and shortened where the last ones go; of a definite K J = 1. Of the six
/// unknowns of a node the last two have no part in B: a node is a jump with three unknowns, the rest is held by
/// itself. With y = L_A⁻¹ u half a solution of A = L_A L_Aᵀ that of K has beside it the rows
///
///     y_e = L⁻¹ (u_e − Wᵀ y),     W = L_A⁻¹ B
///
/// and where A has no half solutions Wᵀ y is Bᵀ (A⁻¹ u).
class Border {
 public:
  /// Forgets all nodes; behind what the solver has factorised last, of so many nodes.
  void begin(DirectSolver& inner, std::size_t num_inner);
  /// Keeps so many nodes of the border and takes those behind from K. False where S is singular, and where J ≠ 1
  /// beside half solutions.
  bool grow(const BlockMatrix& k, std::size_t kept);

  std::size_t num_inner() const { return num_inner_; }
  std::size_t num_nodes() const { return nodes_.size(); }
  /// Negative eigenvalues of S.
  int num_negative() const;

  /// L_A⁻¹ u of right-hand sides, whatever their rows in the border are.
  HalfSolution half_solve(std::span<const HalfSolver::Entry> entries) const;
  /// Adds to y_e the rows that it lacks, for the same right-hand sides. Rows that are there stay what they are, so
  /// that it does not matter when they were added.
  void extend(const HalfSolution& y, std::span<const HalfSolver::Entry> entries, Eigen::MatrixXd& y_e) const;
  /// Turns the sum Σ y s and the rows Σ y_e s beside it into L_A⁻ᵀ-ready sum − W t and t = L⁻ᵀ Σ y_e s.
  void complete(std::span<double> sum, Eigen::VectorXd& t) const;
  /// From x = A⁻¹ b in the rows of A and b_e behind them to K⁻¹ b.
  void correct(std::span<double> x) const;

 private:
  struct Node {
    std::vector<std::pair<BlockId, Mat6>> rows;  ///< Bᵀ: its block in the columns of A
    std::vector<Mat6> below;                     ///< L left of the diagonal
    Mat6 root_inverse = Mat6::Zero();            ///< of L on the diagonal
    Vec6 signs = Vec6::Ones();                   ///< J
    HalfSolution half;                           ///< W
    Eigen::MatrixXd whole;                       ///< A⁻¹ B where there are no half solutions
  };

  void couple(Node& node) const;
  /// Bᵀ A⁻¹ B' of two nodes.
  Mat6 product(const Node& left, const Node& right) const;
  /// Row k of L⁻¹ r, what is above it being known.
  Eigen::MatrixXd row(std::size_t k, Eigen::MatrixXd r, const Eigen::MatrixXd& above) const;
  void back(Eigen::VectorXd& t) const;

  DirectSolver* inner_ = nullptr;
  const HalfSolver* halves_ = nullptr;
  std::size_t num_inner_ = 0;
  std::vector<Node> nodes_;
};

/// out += Σ y_eᵀ y_e' of the nodes from `first` on, one after another.
void add_border_product(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right, std::size_t first,
                        Eigen::MatrixXd& out);

}  // namespace dda
