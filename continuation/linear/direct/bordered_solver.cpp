#include "continuation/linear/direct/bordered_solver.hpp"

#include <algorithm>
#include <vector>

namespace dda {

bool BorderedSolver::factor(const BlockMatrix& a) {
  if (!inner_->factor(a)) return false;
  border_.begin(*inner_, a.num_rows());
  known_.clear();
  return true;
}

void BorderedSolver::solve(std::span<double> x, int columns) {
  if (border_.num_nodes() == 0) return inner_->solve(x, columns);
  const std::size_t n = x.size() / static_cast<std::size_t>(columns),
                    inner = block_unknowns * border_.num_inner();
  std::vector<double> of_inner;
  for (std::size_t at = 0; at < x.size(); at += n)
    of_inner.insert(of_inner.end(), x.begin() + std::ptrdiff_t(at), x.begin() + std::ptrdiff_t(at + inner));
  inner_->solve(of_inner, columns);
  for (std::size_t c = 0; c * n < x.size(); ++c) {
    const std::span<double> column = x.subspan(c * n, n);
    std::copy_n(of_inner.begin() + std::ptrdiff_t(c * inner), inner, column.begin());
    border_.correct(column);
  }
}

void BorderedSolver::solve_again(std::span<double> x) {
  if (border_.num_nodes() == 0) return inner_->solve(x, 1);
  const std::vector<double>& of_inner = known(x.first(block_unknowns * border_.num_inner())).solution;
  std::ranges::copy(of_inner, x.begin());
  border_.correct(x);
}

const BorderedSolver::Known& BorderedSolver::known(std::span<const double> right) {
  const auto found =
      std::ranges::find_if(known_, [&](const Known& one) { return std::ranges::equal(one.right, right); });
  if (found != known_.end()) return *found;
  constexpr std::size_t most = 2;
  if (known_.size() == most) known_.erase(known_.begin());
  Known& out = known_.emplace_back(Known{{right.begin(), right.end()}, {right.begin(), right.end()}});
  inner_->solve(out.solution, 1);
  return out;
}

int BorderedSolver::num_negative_pivots() const {
  const int inner = inner_->num_negative_pivots();
  return inner < 0 ? inner : inner + border_.num_negative();
}

}  // namespace dda
