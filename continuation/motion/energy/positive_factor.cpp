#include "continuation/motion/energy/positive_factor.hpp"

#include <omp.h>

#include <Eigen/CholmodSupport>

namespace dda {
namespace {

/// Columns of L beside each other whose entries are in the same rows, the first of them being their own.
struct Columns {
  Eigen::Index begin, width, num_rows;
  const int* rows;
  const double* values;

  using Values = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
  Values square() const { return {values, width, width, Eigen::OuterStride<>(num_rows)}; }
  Values below() const { return {values + width, num_below(), width, Eigen::OuterStride<>(num_rows)}; }
  Eigen::Index num_below() const { return num_rows - width; }
  int row_below(Eigen::Index i) const { return rows[width + i]; }
};

template <class Number>
const Number* entries(const void* of) {
  return static_cast<const Number*>(of);
}

std::vector<Columns> columns_of(const cholmod_factor& factor) {
  std::vector<Columns> out;
  const double* values = entries<double>(factor.x);
  if (!factor.is_super) {
    const int *first = entries<int>(factor.p), *count = entries<int>(factor.nz),
              *rows = entries<int>(factor.i);
    for (std::size_t c = 0; c < factor.n; ++c)
      out.push_back({static_cast<Eigen::Index>(c), 1, count[c], rows + first[c], values + first[c]});
    return out;
  }
  const int *begin = entries<int>(factor.super), *first_row = entries<int>(factor.pi),
            *first = entries<int>(factor.px), *rows = entries<int>(factor.s);
  for (std::size_t c = 0; c < factor.nsuper; ++c)
    out.push_back({begin[c], begin[c + 1] - begin[c], first_row[c + 1] - first_row[c], rows + first_row[c],
                   values + first[c]});
  return out;
}

}  // namespace

struct PositiveFactor::Cholmod {
  struct Decomposition : Eigen::CholmodDecomposition<Matrix> {
    const cholmod_factor& result() const { return *m_cholmodFactor; }
  };
  Decomposition factor;
  std::vector<Columns> columns = {};

  int original(Eigen::Index row) const { return entries<int>(factor.result().Perm)[row]; }
};

/// CHOLMOD's own threads cost more than they bring, as in CholmodMatrix.
PositiveFactor::PositiveFactor() : cholmod_(std::make_unique<Cholmod>()) {
  omp_set_max_active_levels(0);
  cholmod_common& options = cholmod_->factor.cholmod();
  options.supernodal = CHOLMOD_AUTO;
  options.final_asis = 0;
  options.final_ll = 1;
  options.print = 0;
  options.quick_return_if_not_posdef = true;
}

PositiveFactor::~PositiveFactor() = default;

void PositiveFactor::analyse(const Matrix& lower) { cholmod_->factor.analyzePattern(lower); }

bool PositiveFactor::factorise(const Matrix& lower) {
  cholmod_->factor.factorize(lower);
  if (cholmod_->factor.info() != Eigen::Success) return false;
  cholmod_->columns = columns_of(cholmod_->factor.result());
  return true;
}

Eigen::VectorXd PositiveFactor::solve(const Eigen::VectorXd& right) const {
  return cholmod_->factor.solve(right);
}

double PositiveFactor::Half::dot(const Half& other) const {
  double out = 0;
  for (const auto& [begin, size] : spans)
    out += values.segment(begin, size).dot(other.values.segment(begin, size));
  return out;
}

void PositiveFactor::Half::add_to(Eigen::VectorXd& sum, double factor) const {
  for (const auto& [begin, size] : spans) sum.segment(begin, size) += factor * values.segment(begin, size);
}

PositiveFactor::Half PositiveFactor::half_of(const Eigen::VectorXd& right) const {
  Half out{Eigen::VectorXd(right.size()), {}};
  for (Eigen::Index row = 0; row < right.size(); ++row) out.values[row] = right[cholmod_->original(row)];
  Eigen::VectorXd below;
  for (const Columns& some : cholmod_->columns) {
    auto mine = out.values.segment(some.begin, some.width);
    if ((mine.array() == 0).all()) continue;
    out.spans.emplace_back(some.begin, some.width);
    some.square().triangularView<Eigen::Lower>().solveInPlace(mine);
    below.noalias() = some.below() * mine;
    for (Eigen::Index i = 0; i < below.size(); ++i) out.values[some.row_below(i)] -= below[i];
  }
  return out;
}

Eigen::VectorXd PositiveFactor::other_half_of(Eigen::VectorXd w) const {
  Eigen::VectorXd below;
  for (auto some = cholmod_->columns.rbegin(); some != cholmod_->columns.rend(); ++some) {
    auto mine = w.segment(some->begin, some->width);
    below.resize(some->num_below());
    for (Eigen::Index i = 0; i < below.size(); ++i) below[i] = w[some->row_below(i)];
    mine.noalias() -= some->below().transpose() * below;
    some->square().transpose().triangularView<Eigen::Upper>().solveInPlace(mine);
  }
  Eigen::VectorXd out(w.size());
  for (Eigen::Index row = 0; row < w.size(); ++row) out[cholmod_->original(row)] = w[row];
  return out;
}

Eigen::Index PositiveFactor::num_rows() const { return cholmod_->factor.rows(); }

}  // namespace dda
