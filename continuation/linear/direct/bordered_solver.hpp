#pragma once

#include <memory>
#include <span>
#include <vector>

#include "continuation/linear/direct/border.hpp"
#include "continuation/linear/direct/direct_solver.hpp"

namespace dda {

/// A direct solver whose matrix may get more nodes behind those that it has factorised, and lose the last of them
/// again, at the price of a few solutions (border.hpp):
///
///     [ A  B ; Bᵀ C ] [x; x_e] = [b; b_e],     x_e = S⁻¹ (b_e − Bᵀ A⁻¹ b),     x = A⁻¹ b − A⁻¹ B x_e
///     n₋(K) = n₋(A) + n₋(S)
class BorderedSolver final : public DirectSolver {
 public:
  explicit BorderedSolver(std::unique_ptr<DirectSolver> inner) : inner_(std::move(inner)) {}

  /// All of it becomes A.
  bool factor(const BlockMatrix& a) override;
  /// Makes K the matrix, whose nodes of A and the first `kept` behind them are what they were; A stays. False where
  /// K is singular or not as definite as A.
  bool grow(const BlockMatrix& k, std::size_t kept) { return border_.grow(k, kept); }
  const Border& border() const { return border_; }

  void solve(std::span<double> x, int columns) override;
  /// The same for one of the few right-hand sides that come again each time the border has grown: A⁻¹ b is kept.
  void solve_again(std::span<double> x);
  double factor_bytes(const BlockMatrix& a) override { return inner_->factor_bytes(a); }
  double factor_flops() const override { return inner_->factor_flops(); }
  int num_negative_pivots() const override;
  /// Of A.
  const HalfSolver* halves() const override { return inner_->halves(); }

 private:
  struct Known {
    std::vector<double> right, solution;  ///< b and A⁻¹ b
  };
  const Known& known(std::span<const double> right);

  std::unique_ptr<DirectSolver> inner_;
  Border border_;
  std::vector<Known> known_;
};

}  // namespace dda
