#include "continuation/motion/energy/block_sum.hpp"

#include <algorithm>
#include <utility>

namespace dda {
namespace {

constexpr int size = 6;

}  // namespace

bool BlockSum::set_pattern(std::size_t num_rows, std::vector<Pair> pairs) {
  std::ranges::sort(pairs, {}, [](const Pair& pair) { return std::pair(pair.second, pair.first); });
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
  const std::vector<std::size_t> first_before =
      std::exchange(first_, std::vector<std::size_t>(num_rows + 1, 0));
  const std::vector<std::uint32_t> rows_before = std::exchange(rows_, {});
  for (const auto& [row, column] : pairs) {
    ++first_[column + 1];
    rows_.push_back(row);
  }
  for (std::size_t c = 0; c < num_rows; ++c) first_[c + 1] += first_[c];
  if (first_ == first_before && rows_ == rows_before) return false;
  diagonal_.assign(num_rows, Mat6::Zero());
  below_.assign(rows_.size(), Mat6::Zero());
  place_of_last_ = none;
  const auto n = static_cast<Eigen::Index>(size * num_rows);
  matrix_.resize(n, n);
  std::vector<int> starts{0}, inner;
  for (std::size_t b = 0; b < num_rows; ++b)
    for (int c = 0; c < size; ++c) {
      for (int r = c; r < size; ++r) inner.push_back(size * static_cast<int>(b) + r);
      for (std::size_t k = first_[b]; k < first_[b + 1]; ++k)
        for (int r = 0; r < size; ++r) inner.push_back(size * static_cast<int>(rows_[k]) + r);
      starts.push_back(static_cast<int>(inner.size()));
    }
  matrix_.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::ranges::copy(starts, matrix_.outerIndexPtr());
  std::ranges::copy(inner, matrix_.innerIndexPtr());
  return true;
}

void BlockSum::append_pairs(std::vector<Pair>& out) const {
  for (std::size_t column = 0; column < num_rows(); ++column)
    for (std::size_t k = first_[column]; k < first_[column + 1]; ++k)
      out.emplace_back(rows_[k], static_cast<std::uint32_t>(column));
}

bool BlockSum::covers(const std::vector<Pair>& pairs) const {
  return std::ranges::all_of(
      pairs, [&](const Pair& pair) { return place_of(pair.first, pair.second) < rows_.size(); });
}

std::size_t BlockSum::place_of(std::uint32_t row, std::uint32_t column) const {
  const auto begin = rows_.begin() + static_cast<std::ptrdiff_t>(first_[column]),
             end = rows_.begin() + static_cast<std::ptrdiff_t>(first_[column + 1]);
  const auto found = std::lower_bound(begin, end, row);
  return found == end || *found != row ? rows_.size() : static_cast<std::size_t>(found - rows_.begin());
}

void BlockSum::set_zero() {
  for (auto* blocks : {&diagonal_, &below_})
    for (Mat6& block : *blocks) block.setZero();
}

void BlockSum::add(std::size_t i, std::size_t j, const Mat6& m) {
  if (i == j)
    diagonal_[i] += m;
  else if (i > j)
    below(i, j) += m;
}

void BlockSum::add(std::size_t i, std::size_t j, const Vec6& a, const Vec6& b) {
  if (i >= j) (i == j ? diagonal_[i] : below(i, j)).noalias() += a * b.transpose();
}

Mat6& BlockSum::below(std::size_t row, std::size_t column) {
  const Pair pair(static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column));
  if (pair != last_ || place_of_last_ == none) {
    place_of_last_ = place_of(pair.first, pair.second);
    last_ = pair;
  }
  return below_.at(place_of_last_);
}

const BlockSum::Matrix& BlockSum::matrix() {
  double* value = matrix_.valuePtr();
  for (std::size_t b = 0; b < num_rows(); ++b)
    for (int c = 0; c < size; ++c) {
      for (int r = c; r < size; ++r) *value++ = diagonal_[b](r, c);
      for (std::size_t k = first_[b]; k < first_[b + 1]; ++k)
        for (int r = 0; r < size; ++r) *value++ = below_[k](r, c);
    }
  return matrix_;
}

}  // namespace dda
