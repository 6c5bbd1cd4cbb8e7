// What a factorisation with a border leaves for others, and takes from them.
#include <algorithm>

#include "continuation/linear/cholesky/cholmod_arrays.hpp"
#include "continuation/linear/cholesky/cholmod_matrix.hpp"
#include "continuation/linear/dense/dense_cholesky.hpp"

namespace dda {

void CholmodMatrix::to_factor(std::span<double> x) const {
  turned_.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) turned_[count(position_[i])] = x[i];
  std::ranges::copy(turned_, x.begin());
}

void CholmodMatrix::begin(std::span<double> x, int columns) const {
  Eigen::VectorXd below;
  for (std::size_t c = 0; c < count(columns); ++c) {
    const std::span<double> column = x.subspan(c * factor_->n, factor_->n);
    to_factor(column);
    for (int s = 0; s < static_cast<int>(factor_->nsuper) && count(super_[s]) < eliminated_; ++s) {
      const Supernode node = supernode(s);
      const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> l(node.values, node.rows, node.size,
                                                                         Eigen::OuterStride<>(node.rows));
      Eigen::Map<Eigen::VectorXd> here(column.data() + node.first, node.size);
      l.topRows(node.size).triangularView<Eigen::Lower>().solveInPlace(here);
      const int more = node.rows - node.size;
      below.noalias() = l.bottomRows(more) * here;
      for (int i = 0; i < more; ++i) column[count(node.row[node.size + i])] -= below[i];
    }
  }
}

/// CHOLMOD has no factorisation that stops before the border: what it has made of it tells what it would have left.
std::vector<double> CholmodMatrix::border_update() {
  const auto size = static_cast<Eigen::Index>(num_border_rows());
  Eigen::MatrixXd square = Eigen::MatrixXd::Zero(size, size);  // L_B, then L_B L_Bᵀ
  for (int s = 0; s < static_cast<int>(factor_->nsuper); ++s) {
    const int first = super_[s], end = super_[s + 1];
    const Supernode node = supernode(s);
    for (int c = std::max(first, static_cast<int>(eliminated_)); c < end; ++c)
      for (int i = c - first; i < node.rows; ++i)
        square(node.row[i] - static_cast<int>(eliminated_), c - static_cast<int>(eliminated_)) =
            node.values[std::ptrdiff_t(c - first) * node.rows + i];
  }
  square_of_factor(square);
  const int* start = integers(matrix_->p);
  for (std::size_t c = eliminated_; c < factor_->n; ++c)  // the upper triangle, column by column
    for (int i = start[c]; i < start[c + 1]; ++i)
      if (const std::size_t row = count(integers(matrix_->i)[i]); row >= eliminated_)
        square(static_cast<Eigen::Index>(c - eliminated_), static_cast<Eigen::Index>(row - eliminated_)) -=
            reals(matrix_->x)[i];
  cholmod_free_sparse(&matrix_, &common_);
  std::vector<double> out;
  out.reserve(static_cast<std::size_t>(size * (size + 1) / 2));
  for (Eigen::Index c = 0; c < size; ++c) out.insert(out.end(), &square(c, c), square.col(c).data() + size);
  return out;
}

}  // namespace dda
