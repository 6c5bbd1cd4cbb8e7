#include "continuation/linear/strips/between.hpp"

#include <algorithm>
#include <iterator>

#include "continuation/linear/dense/dense_cholesky.hpp"

namespace dda {

using Matrix = Eigen::MatrixXd;

void Between::begin(const std::vector<std::size_t>& rows) {
  diagonal_.clear();
  below_.clear();
  for (std::size_t place = 0; place < rows.size(); ++place) {
    const auto size = static_cast<Eigen::Index>(rows[place]);
    diagonal_.emplace_back(Matrix::Zero(size, size));
    if (place > 0) below_.emplace_back(Matrix::Zero(size, diagonal_[place - 1].cols()));
  }
}

void Between::add_strip(std::size_t strip, const std::vector<double>& lower) {
  const Eigen::Index before = strip > 0 ? diagonal_[strip - 1].rows() : 0,
                     behind = strip < size() ? diagonal_[strip].rows() : 0;
  const double* from = lower.data();
  for (Eigen::Index c = 0; c < before; ++c) {
    auto column = diagonal_[strip - 1].col(c).tail(before - c);
    column += Eigen::Map<const Eigen::VectorXd>(from, column.size());
    from += column.size();
    if (behind > 0) below_[strip - 1].col(c) += Eigen::Map<const Eigen::VectorXd>(from, behind);
    from += behind;
  }
  for (Eigen::Index c = 0; c < behind; ++c) {
    auto column = diagonal_[strip].col(c).tail(behind - c);
    column += Eigen::Map<const Eigen::VectorXd>(from, column.size());
    from += column.size();
  }
}

bool Between::factor() {
  for (std::size_t place = 0; place < size(); ++place) {
    if (place > 0) {
      divide_by_transpose(diagonal_[place - 1], below_[place - 1]);
      subtract_square(below_[place - 1], diagonal_[place]);
    }
    if (!factor_cholesky(diagonal_[place])) return false;
  }
  return true;
}

double Between::factor_flops() const {
  double out = 0;
  for (std::size_t place = 0; place < size(); ++place) {
    const auto n = static_cast<double>(diagonal_[place].rows());
    out += n * n * n / 3;
    if (place > 0) {
      const auto m = static_cast<double>(below_[place - 1].cols());
      out += n * m * m + n * n * m;
    }
  }
  return out;
}

double Between::bytes() const {
  double out = 0;
  for (const auto* all : {&diagonal_, &below_})
    for (const Matrix& block : *all) out += sizeof(double) * static_cast<double>(block.size());
  return out;
}

BetweenColumns Between::zero(std::size_t first, Eigen::Index columns) const {
  BetweenColumns out{first, {}};
  for (std::size_t place = first; place < size(); ++place)
    out.at.emplace_back(Matrix::Zero(diagonal_[place].rows(), columns));
  return out;
}

void Between::half_solve(BetweenColumns& b) const {
  for (std::size_t i = 0; i < b.at.size(); ++i) {
    const std::size_t place = b.first + i;
    for (Eigen::Index c = 0; c < b.at[i].cols(); ++c) {
      auto here = b.at[i].col(c);
      if (i > 0) here.noalias() -= below_[place - 1] * b.at[i - 1].col(c);
      diagonal_[place].triangularView<Eigen::Lower>().solveInPlace(here);
    }
  }
}

void Between::complete(BetweenColumns& y) const {
  if (size() == 0) return;
  if (y.first > 0) {
    BetweenColumns all = zero(0, y.at.empty() ? 1 : y.at.front().cols());
    std::ranges::move(y.at, all.at.begin() + std::ptrdiff_t(y.first));
    y = std::move(all);
  }
  for (std::size_t place = size(); place-- > 0;)
    for (Eigen::Index c = 0; c < y.at[place].cols(); ++c) {
      auto here = y.at[place].col(c);
      if (place + 1 < size()) here.noalias() -= below_[place].transpose() * y.at[place + 1].col(c);
      diagonal_[place].triangularView<Eigen::Lower>().transpose().solveInPlace(here);
    }
}

void Between::add_product(const BetweenColumns& x, const BetweenColumns& y, Eigen::Ref<Matrix> out) {
  for (std::size_t place = std::max(x.first, y.first); place < x.first + x.at.size(); ++place)
    out.noalias() += x.at[place - x.first].transpose() * y.at[place - y.first];
}

}  // namespace dda
