#include "continuation/linear/direct/border.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>

#include "continuation/linear/direct/direct_solver.hpp"

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;

constexpr Eigen::Index coupled = 4;  // columns of B that may differ from zero, in pairs

Eigen::Index row_of(std::size_t node) { return block_unknowns * static_cast<Eigen::Index>(node); }

/// r −= a x, column by column: last digits do not hang on how many there are.
void subtract_product(const Mat6& a, const Matrix& x, Eigen::Index first, Matrix& r) {
  for (Eigen::Index c = 0; c < r.cols(); ++c) {
    const Vec6 of = x.block<6, 1>(first, c);
    r.col(c) -= Vec6(a * of);
  }
}

/// Of a symmetric matrix D = F J Fᵀ.
struct Root {
  Mat6 inverse;
  Vec6 signs;
};

/// False in `found` where D is singular beside the diagonal that it is left of.
bool find_root(const Mat6& d, const Vec6& diagonal, Root& found) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const Vec6 scale = diagonal.cwiseAbs().cwiseSqrt();
  if (!(scale.minCoeff() > 0)) return false;
  const Vec6 inverse = scale.cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Mat6> own(inverse.asDiagonal() * d * inverse.asDiagonal());
  const Vec6 values = own.eigenvalues();
  if (!(values.cwiseAbs().minCoeff() > rounding)) return false;
  found.signs = values.cwiseSign();
  found.inverse = values.cwiseAbs().cwiseSqrt().cwiseInverse().asDiagonal() * own.eigenvectors().transpose() *
                  inverse.asDiagonal();
  return true;
}

}  // namespace

void Border::begin(DirectSolver& inner, std::size_t num_inner) {
  inner_ = &inner;
  halves_ = inner.halves();
  num_inner_ = num_inner;
  nodes_.clear();
}

int Border::num_negative() const {
  int out = 0;
  for (const Node& node : nodes_) out += static_cast<int>((node.signs.array() < 0).count());
  return out;
}

void Border::couple(Node& node) const {
  if (halves_) {
    std::vector<HalfSolver::Entry> entries;
    for (const auto& [block, rows] : node.rows)
      for (Eigen::Index pair = 0; 2 * pair < coupled; ++pair)
        entries.push_back({block, rows.transpose().middleCols<2>(2 * pair), pair});
    node.half = halves_->half_solve(entries);
    return;
  }
  node.whole = Matrix::Zero(row_of(num_inner_), coupled);
  for (const auto& [block, rows] : node.rows)
    node.whole.middleRows<6>(row_of(block.value())) = rows.transpose().leftCols<coupled>();
  inner_->solve({node.whole.data(), static_cast<std::size_t>(node.whole.size())}, coupled);
}

Mat6 Border::product(const Node& left, const Node& right) const {
  Mat6 out = Mat6::Zero();
  if (halves_) {
    out.topLeftCorner<coupled, coupled>() = halves_->product(left.half, right.half);
    return out;
  }
  for (const auto& [block, rows] : left.rows)
    out.leftCols<coupled>() += rows * right.whole.middleRows<6>(row_of(block.value()));
  return out;
}

bool Border::grow(const BlockMatrix& k, std::size_t kept) {
  nodes_.resize(std::min(kept, nodes_.size()));
  for (std::size_t n = nodes_.size(); num_inner_ + n < k.num_rows(); ++n) {
    Node node;
    std::vector<Mat6> right(n, Mat6::Zero());
    Mat6 d = Mat6::Zero();
    for (std::size_t s = k.row_start()[num_inner_ + n]; s < k.row_start()[num_inner_ + n + 1]; ++s) {
      const std::size_t column = k.columns()[s];
      if (column < num_inner_)
        node.rows.emplace_back(BlockId{column}, k.value(s));
      else if (column < num_inner_ + n)
        right[column - num_inner_] = k.value(s).transpose();
      else if (column == num_inner_ + n)
        d = k.value(s);
    }
    const Vec6 diagonal = d.diagonal();
    couple(node);
    Matrix above(row_of(n), block_unknowns);
    for (std::size_t j = 0; j < n; ++j) {
      above.middleRows<6>(row_of(j)) = row(j, right[j] - product(nodes_[j], node), above);
      node.below.push_back((nodes_[j].signs.asDiagonal() * Mat6(above.middleRows<6>(row_of(j)))).transpose());
      d -= node.below.back() * Mat6(above.middleRows<6>(row_of(j)));
    }
    d -= product(node, node);
    Root root;
    if (!find_root(d, diagonal, root) || (halves_ && root.signs.minCoeff() < 0)) return false;
    node.root_inverse = root.inverse;
    node.signs = root.signs;
    nodes_.push_back(std::move(node));
  }
  return true;
}

Eigen::MatrixXd Border::row(std::size_t k, Matrix r, const Matrix& above) const {
  for (std::size_t j = 0; j < k; ++j) subtract_product(nodes_[k].below[j], above, row_of(j), r);
  for (Eigen::Index c = 0; c < r.cols(); ++c) {
    const Vec6 of = r.col(c);
    r.col(c) = nodes_[k].root_inverse * of;
  }
  return r;
}

HalfSolution Border::half_solve(std::span<const HalfSolver::Entry> entries) const {
  std::vector<HalfSolver::Entry> inner;
  for (const HalfSolver::Entry& entry : entries)
    if (entry.block.value() < num_inner_) inner.push_back(entry);
  return halves_->half_solve(inner);
}

void Border::extend(const HalfSolution& y, std::span<const HalfSolver::Entry> entries, Matrix& y_e) const {
  const auto first = static_cast<std::size_t>(y_e.rows() / block_unknowns);
  y_e.conservativeResize(row_of(nodes_.size()), y.columns);
  for (std::size_t k = first; k < nodes_.size(); ++k) {
    Matrix r = Matrix::Zero(block_unknowns, y.columns);
    for (const HalfSolver::Entry& entry : entries)
      if (entry.block.value() == num_inner_ + k) r.middleCols<2>(2 * entry.pair) += entry.rows;
    r.topRows<coupled>() -= halves_->product(nodes_[k].half, y);
    y_e.middleRows<6>(row_of(k)) = row(k, std::move(r), y_e);
  }
}

/// L⁻ᵀ t.
void Border::back(Eigen::VectorXd& t) const {
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const Vec6 here = nodes_[k].root_inverse.transpose() * Vec6(t.segment<6>(row_of(k)));
    t.segment<6>(row_of(k)) = here;
    for (std::size_t j = 0; j < k; ++j)
      t.segment<6>(row_of(j)) -= Vec6(nodes_[k].below[j].transpose() * here);
  }
}

void Border::complete(std::span<double> sum, Eigen::VectorXd& t) const {
  back(t);
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    halves_->add(nodes_[k].half, 0, -t.segment<coupled>(row_of(k)), sum);
}

void Border::correct(std::span<double> x) const {
  const std::span<double> of_inner = x.first(block_unknowns * num_inner_);
  Matrix y(row_of(nodes_.size()), 1);
  Eigen::VectorXd t(y.rows());
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    Vec6 r(x.data() + block_unknowns * (num_inner_ + k));
    for (const auto& [block, rows] : nodes_[k].rows)
      r -= Vec6(rows * Vec6(of_inner.data() + block_unknowns * block.value()));
    y.middleRows<6>(row_of(k)) = row(k, r, y);
    t.segment<6>(row_of(k)) = nodes_[k].signs.cwiseProduct(Vec6(y.middleRows<6>(row_of(k))));
  }
  std::vector<double> moved(of_inner.size(), 0.0);
  if (halves_) {
    complete(moved, t);
    halves_->complete(moved, 1);
  } else {
    back(t);
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      Eigen::Map<Eigen::VectorXd>(moved.data(), std::ssize(moved)).noalias() -=
          nodes_[k].whole * t.segment<coupled>(row_of(k));
  }
  for (std::size_t i = 0; i < moved.size(); ++i) x[i] += moved[i];
  std::copy(t.begin(), t.end(), x.begin() + std::ssize(of_inner));
}

void add_border_product(const Matrix& left, const Matrix& right, std::size_t first, Matrix& out) {
  for (Eigen::Index k = row_of(first); k < left.rows(); k += block_unknowns)
    for (Eigen::Index i = 0; i < out.rows(); ++i)
      for (Eigen::Index j = 0; j < out.cols(); ++j) {
        const Vec6 a = left.block<6, 1>(k, i), b = right.block<6, 1>(k, j);
        out(i, j) += a.dot(b);
      }
}

}  // namespace dda
