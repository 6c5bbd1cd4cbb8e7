#include "continuation/linear/dense/condensed_update.hpp"

#include <algorithm>
#include <utility>

#include "continuation/linear/dense/dense_product.hpp"
#include "continuation/linear/dense/two_by_two.hpp"
#include "framework/base/threads.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;

Matrix rows_of(const Matrix& of, const std::vector<std::size_t>& points) {
  Matrix out(pair_at(points.size()), of.cols());
  for (std::size_t i = 0; i < points.size(); ++i)
    out.middleRows<2>(pair_at(i)) = of.middleRows<2>(pair_at(points[i]));
  return out;
}

}  // namespace

void CondensedUpdate::begin(const std::vector<Mat2>& e, const std::vector<bool>& is_steady) {
  if (!eliminate(e, is_steady)) forget();
  set(e);
}

bool CondensedUpdate::eliminate(const std::vector<Mat2>& e, const std::vector<bool>& is_steady) {
  constexpr std::size_t fewest = 32;
  e_ = e;
  forget();
  for (std::size_t p = 0; p < e.size(); ++p)
    if (is_steady[p] && !e[p].isZero(0)) steady_.push_back(p);
  if (steady_.size() < fewest) return false;
  for (std::size_t i = 0; i < steady_.size(); ++i) {
    place_[steady_[i]] = static_cast<int>(i);
    e_steady_[steady_[i]] = e[steady_[i]];
  }
  Matrix h = couplings(steady_, steady_);
  for (std::size_t i = 0; i < steady_.size(); ++i)
    h.middleCols<2>(pair_at(i)) = (h.middleCols<2>(pair_at(i)) * e[steady_[i]]).eval();
  h.diagonal().array() += 1;
  to_steady_.resize(h.rows(), 0);
  from_outside_.resize(h.rows(), 0);
  return lu_.compute(std::move(h));
}

void CondensedUpdate::forget() {
  steady_.clear();
  changing_.clear();
  outside_.clear();
  place_.assign(e_.size(), -1);
  is_changing_.assign(e_.size(), false);
  e_steady_.assign(e_.size(), Mat2::Zero());
  lu_ = {};
  to_steady_.resize(0, 0);
  from_outside_.resize(0, 0);
  between_.resize(0, 0);
}

void CondensedUpdate::set(const std::vector<Mat2>& e) {
  e_ = e;
  if (steady_.empty()) forget();
  Points more;
  for (std::size_t p = 0; p < e.size(); ++p)
    if (!is_changing_[p] && !is_same(e[p], e_steady_[p])) more.push_back(p);
  if (!more.empty()) add_changing(more);
  Matrix matrix = between_;
  for (std::size_t i = 0; i < changing_.size(); ++i) {
    const Mat2 change = e[changing_[i]] - e_steady_[changing_[i]];
    matrix.middleCols<2>(pair_at(i)) = (matrix.middleCols<2>(pair_at(i)) * change).eval();
  }
  matrix.diagonal().array() += 1;
  small_.compute(std::move(matrix));  // a singular one gives no number
}

void CondensedUpdate::add_changing(const Points& points) {
  const std::size_t first = changing_.size(), first_outside = outside_.size();
  for (const std::size_t p : points) {
    if (place_[p] < 0) outside_.push_back(changing_.size());
    is_changing_[p] = true;
    changing_.push_back(p);
  }
  if (!steady_.empty()) {
    to_steady_.conservativeResize(Eigen::NoChange, pair_at(changing_.size()));
    to_steady_.rightCols(pair_at(points.size())) = lu_.solve(couplings(steady_, points));
    from_outside_.conservativeResize(Eigen::NoChange, pair_at(outside_.size()));
    for (std::size_t i = first_outside; i < outside_.size(); ++i)
      for (std::size_t s = 0; s < steady_.size(); ++s)
        from_outside_.block<2, 2>(pair_at(s), pair_at(i)) =
            (g_.block<2, 2>(pair_at(changing_[outside_[i]]), pair_at(steady_[s])) * e_steady_[steady_[s]])
                .transpose();
  }
  fill_changing(first);
}

/// M_CC, which was there for the first points: S has its rows, M = G − G E₀ M gives those outside.
void CondensedUpdate::fill_changing(std::size_t first) {
  const std::size_t count = changing_.size(),
                    first_outside = static_cast<std::size_t>(std::ranges::lower_bound(outside_, first) -
                                                             outside_.begin());
  between_.conservativeResize(pair_at(count), pair_at(count));
  const auto fill = [&](std::size_t begin, Eigen::Index column, Eigen::Index columns) {
    Matrix product = Matrix::Zero(pair_at(outside_.size() - begin), columns);
    if (!steady_.empty())
      product = product_of_transpose(from_outside_.rightCols(product.rows()),
                                     to_steady_.middleCols(column, columns));
    for (std::size_t i = begin; i < outside_.size(); ++i)
      for (Eigen::Index c = column; c < column + columns; c += 2)
        between_.block<2, 2>(pair_at(outside_[i]), c) =
            g_.block<2, 2>(pair_at(changing_[outside_[i]]),
                           pair_at(changing_[static_cast<std::size_t>(c / 2)])) -
            product.block<2, 2>(pair_at(i - begin), c - column);
  };
  for (std::size_t i = 0; i < count; ++i)
    if (const int place = place_[changing_[i]]; place >= 0)
      between_.middleRows<2>(pair_at(i)) = to_steady_.middleRows<2>(2 * place);
  fill(0, pair_at(first), pair_at(count - first));
  if (first > 0) fill(first_outside, 0, pair_at(first));
}

Eigen::MatrixXd CondensedUpdate::couplings(const Points& rows, const Points& columns) const {
  Matrix out(pair_at(rows.size()), pair_at(columns.size()));
  constexpr std::size_t columns_at_once = 64;
  parallel_for(columns.size(), columns_at_once, [&](std::size_t c) {
    for (std::size_t r = 0; r < rows.size(); ++r)
      out.block<2, 2>(pair_at(r), pair_at(c)) = g_.block<2, 2>(pair_at(rows[r]), pair_at(columns[c]));
  });
  return out;
}

Eigen::MatrixXd CondensedUpdate::condensed(const Matrix& b) const {
  Matrix out = Matrix::Zero(b.rows(), b.cols()), of_steady = lu_.solve(rows_of(b, steady_)),
         y = rows_of(b, changing_);
  if (!steady_.empty()) {
    const Matrix from = from_outside_.transpose() * of_steady;
    for (std::size_t i = 0; i < outside_.size(); ++i)
      y.middleRows<2>(pair_at(outside_[i])) -= from.middleRows<2>(pair_at(i));
    for (std::size_t i = 0; i < changing_.size(); ++i)
      if (const int place = place_[changing_[i]]; place >= 0)
        y.middleRows<2>(pair_at(i)) = of_steady.middleRows<2>(2 * place);
  }
  y = small_.solve(std::move(y));
  for (std::size_t i = 0; i < changing_.size(); ++i)
    out.middleRows<2>(pair_at(changing_[i])) = y.middleRows<2>(pair_at(i));
  if (steady_.empty()) return out;
  for (std::size_t i = 0; i < changing_.size(); ++i)
    y.middleRows<2>(pair_at(i)) =
        ((e_[changing_[i]] - e_steady_[changing_[i]]) * y.middleRows<2>(pair_at(i))).eval();
  of_steady.noalias() -= to_steady_ * y;
  for (std::size_t i = 0; i < steady_.size(); ++i)
    if (!is_changing_[steady_[i]])
      out.middleRows<2>(pair_at(steady_[i])) = of_steady.middleRows<2>(pair_at(i));
  return out;
}

void CondensedUpdate::subtract_product(const Matrix& y, Matrix& x) const {
  constexpr std::size_t rows_at_once = 500;
  parallel_pieces(static_cast<std::size_t>(x.rows()), rows_at_once, [&](std::size_t begin, std::size_t end) {
    const auto first = static_cast<Eigen::Index>(begin), rows = static_cast<Eigen::Index>(end - begin);
    for (std::size_t p = 0; p < e_.size(); ++p)
      for (Eigen::Index c = 0; c < x.cols() && !e_[p].isZero(0); ++c)
        x.col(c).segment(first, rows).noalias() -=
            g_.block(first, pair_at(p), rows, 2) * Vec2(e_[p] * y.col(c).segment<2>(pair_at(p)));
  });
}

/// Overwrites x by what it leaves right everywhere; by how much it missed that.
double CondensedUpdate::refine(const Matrix& b, Matrix& x) const {
  Matrix known = x;
  constexpr int times = 3;
  constexpr double rounding = 1e-13;
  double missed = 0;
  for (int i = 0; i < times; ++i) {
    x = b;
    subtract_product(known, x);
    Matrix miss = Matrix::Zero(x.rows(), x.cols());
    for (std::size_t p = 0; p < e_.size(); ++p)
      if (is_known(p))
        miss.middleRows<2>(pair_at(p)) = x.middleRows<2>(pair_at(p)) - known.middleRows<2>(pair_at(p));
    missed = miss.cwiseAbs().maxCoeff() / std::max(x.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
    if (!(missed > rounding) || steady_.empty()) break;
    known += condensed(miss);
  }
  return missed;
}

void CondensedUpdate::solve(Matrix& x) {
  if (steady_.empty() && changing_.empty()) return;
  constexpr double good = 1e-11;
  const Matrix b = x;
  x = condensed(b);
  if (refine(b, x) <= good || steady_.empty()) return;
  steady_.clear();
  set(std::vector<Mat2>(e_));
  x = condensed(b);
  refine(b, x);
}

}  // namespace dda
