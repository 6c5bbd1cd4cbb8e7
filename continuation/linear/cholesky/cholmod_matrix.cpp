#include "continuation/linear/cholesky/cholmod_matrix.hpp"

#include <omp.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "continuation/linear/cholesky/cholmod_arrays.hpp"

namespace dda {
namespace {

constexpr int upper = 1, lower = -1;  // stype: which triangle is stored

/// A matrix of this thread for sparse right-hand sides, zero between the calls.
Eigen::Map<Eigen::MatrixXd> scratch(std::size_t rows, Eigen::Index columns) {
  thread_local std::vector<double> values;
  if (values.size() < rows * static_cast<std::size_t>(columns))
    values.assign(rows * static_cast<std::size_t>(columns), 0.0);
  return {values.data(), static_cast<Eigen::Index>(rows), columns};
}

/// Rows of a half solution.
using RowMajorMap = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

/// xᵀ y of a few columns from these places on, which fit in the registers: a general product would turn x and y
/// first, which takes longer.
template <int Rows, int Columns, class Tile>
void add_tile(const RowMajorMap& x, const RowMajorMap& y, Tile out) {
  using Left = Eigen::Map<const Eigen::Matrix<double, Rows, 1>>;
  using Right = Eigen::Map<const Eigen::Matrix<double, 1, Columns>>;
  Eigen::Matrix<double, Rows, Columns> sum = Eigen::Matrix<double, Rows, Columns>::Zero();
  const double *left = x.data() + out.startRow(), *right = y.data() + out.startCol();
  for (Eigen::Index k = 0; k < x.rows(); ++k, left += x.cols(), right += y.cols())
    sum.noalias() += Left(left).lazyProduct(Right(right));
  out += sum;
}

/// out += xᵀ y; columns come in pairs.
void add_product(const RowMajorMap& x, const RowMajorMap& y, Eigen::MatrixXd& out) {
  for (Eigen::Index i = 0; i < x.cols(); i += 4)
    for (Eigen::Index j = 0; j < y.cols(); j += 4) {
      const bool is_low = i + 2 == x.cols(), is_narrow = j + 2 == y.cols();
      if (is_low && is_narrow)
        add_tile<2, 2>(x, y, out.block<2, 2>(i, j));
      else if (is_low)
        add_tile<2, 4>(x, y, out.block<2, 4>(i, j));
      else if (is_narrow)
        add_tile<4, 2>(x, y, out.block<4, 2>(i, j));
      else
        add_tile<4, 4>(x, y, out.block<4, 4>(i, j));
    }
}

using Entries = Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

}  // namespace

/// CHOLMOD asks OpenMP for four threads in loops of microseconds, whatever OMP_NUM_THREADS says: they cost
/// more than they bring.
CholmodMatrix::CholmodMatrix() {
  omp_set_max_active_levels(0);
  cholmod_start(&common_);
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.print = 0;
  common_.quick_return_if_not_posdef = true;
}

CholmodMatrix::~CholmodMatrix() {
  for (cholmod_dense*& work : work_) cholmod_free_dense(&work, &common_);
  cholmod_free_sparse(&matrix_, &common_);
  cholmod_free_factor(&factor_, &common_);
  cholmod_finish(&common_);
}

bool CholmodMatrix::factor(const BlockMatrix& a, std::size_t border) {
  assemble(a);
  if (a.row_start() != pattern_rows_ || a.columns() != pattern_columns_ || border != border_) {
    border_ = border;
    analyse(a);
  }
  cholmod_factorize(matrix_, factor_, &common_);
  check("factorise");
  if (common_.status == CHOLMOD_NOT_POSDEF || has_lost_a_pivot()) return false;
  index_supernodes();
  return true;
}

void CholmodMatrix::forget() {
  cholmod_free_sparse(&matrix_, &common_);
  constexpr int as_squares = true, supernodal = true, packed = true, in_order = true;
  if (factor_)
    cholmod_change_factor(CHOLMOD_PATTERN, as_squares, supernodal, packed, in_order, factor_, &common_);
  for (cholmod_dense*& work : work_) cholmod_free_dense(&work, &common_);
}

double CholmodMatrix::factor_bytes(const BlockMatrix& a, std::size_t border) {
  assemble(a);
  border_ = border;
  analyse(a);
  const double of_factor = static_cast<double>(factor_->xsize) * sizeof(double) +
                           static_cast<double>(factor_->ssize) * sizeof(int);
  return of_factor + static_cast<double>(matrix_->nzmax) * (sizeof(double) + sizeof(int));
}

void CholmodMatrix::assemble(const BlockMatrix& a) {
  constexpr std::size_t size = block_unknowns;
  const std::size_t n = size * a.num_rows();
  std::size_t entries = 0;
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s)
      if (a.columns()[s] <= r) entries += a.columns()[s] == r ? size * (size + 1) / 2 : size * size;
  cholmod_free_sparse(&matrix_, &common_);
  matrix_ = cholmod_allocate_sparse(n, n, entries, false, true, upper, CHOLMOD_REAL, &common_);
  check("store");
  int* start = integers(matrix_->p);
  int* row = integers(matrix_->i);
  double* value = reals(matrix_->x);
  int next = 0;
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    for (std::size_t j = 0; j < size; ++j) {
      start[size * r + j] = next;
      for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s) {
        const std::size_t c = a.columns()[s];
        if (c > r) continue;
        for (std::size_t i = 0; i < (c == r ? j + 1 : size); ++i) {
          row[next] = static_cast<int>(size * c + i);
          value[next++] = a.value(s)(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i));
        }
      }
    }
  start[n] = next;
}

void CholmodMatrix::analyse(const BlockMatrix& a) {
  pattern_rows_ = a.row_start();
  pattern_columns_ = a.columns();
  eliminated_ = block_unknowns * (a.num_rows() - border_);
  std::vector<int> unknowns = dissected(a);
  common_.nmethods = 1;
  common_.method[0].ordering = CHOLMOD_GIVEN;
  if (border_ > 0) {
    unknowns = along_the_tree(std::move(unknowns));
    for (std::size_t i = eliminated_; i < block_unknowns * a.num_rows(); ++i)
      unknowns.push_back(static_cast<int>(i));
  }
  cholmod_free_factor(&factor_, &common_);
  common_.postorder = border_ == 0;
  factor_ = cholmod_analyze_p(matrix_, unknowns.data(), nullptr, 0, &common_);
  common_.postorder = true;
  check("analyse");
}

/// The blocks are ordered by nested dissection of their graph, a sixth of the matrix's.
std::vector<int> CholmodMatrix::dissected(const BlockMatrix& a) {
  const std::size_t m = a.num_rows() - border_;
  cholmod_sparse* graph =
      cholmod_allocate_sparse(m, m, a.num_stored(), false, true, lower, CHOLMOD_PATTERN, &common_);
  check("store");
  int* row = integers(graph->i);
  int next = 0;
  for (std::size_t c = 0; c < m; ++c) {
    integers(graph->p)[c] = next;
    for (std::size_t s = a.row_start()[c]; s < a.row_start()[c + 1]; ++s)
      if (a.columns()[s] >= c && a.columns()[s] < m) row[next++] = static_cast<int>(a.columns()[s]);
  }
  integers(graph->p)[m] = next;
  std::vector<int> blocks(m), parents(m), members(m), unknowns;
  cholmod_nested_dissection(graph, nullptr, 0, blocks.data(), parents.data(), members.data(), &common_);
  cholmod_free_sparse(&graph, &common_);
  check("order");
  for (const int block : blocks)
    for (int i = 0; i < block_unknowns; ++i) unknowns.push_back(block_unknowns * block + i);
  return unknowns;
}

std::vector<int> CholmodMatrix::along_the_tree(std::vector<int> order) {
  cholmod_sparse leading = *matrix_;  // its columns have rows above the diagonal alone
  leading.nrow = leading.ncol = eliminated_;
  cholmod_factor* inner = cholmod_analyze_p(&leading, order.data(), nullptr, 0, &common_);
  check("analyse");
  std::copy_n(integers(inner->Perm), eliminated_, order.begin());
  cholmod_free_factor(&inner, &common_);
  return order;
}

bool CholmodMatrix::has_lost_a_pivot() const {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  const int* start = integers(matrix_->p);
  const double* value = reals(matrix_->x);
  const int* unknown = integers(factor_->Perm);
  const int num_supernodes = static_cast<int>(factor_->nsuper);
  for (int s = 0; s < num_supernodes; ++s) {
    const int first = integers(factor_->super)[s], end = integers(factor_->super)[s + 1];
    const int rows = integers(factor_->pi)[s + 1] - integers(factor_->pi)[s];
    const double* l = reals(factor_->x) + integers(factor_->px)[s];
    for (int c = first; c < end; ++c, l += rows + 1) {
      const double diagonal = value[start[unknown[c] + 1] - 1];  // the last entry of its column
      if (!(*l * *l > rounding * diagonal)) return true;
    }
  }
  return false;
}

void CholmodMatrix::index_supernodes() {
  super_ = integers(factor_->super);
  supernode_of_.resize(factor_->n);
  for (int s = 0; s < static_cast<int>(factor_->nsuper); ++s)
    std::fill(supernode_of_.begin() + super_[s], supernode_of_.begin() + super_[s + 1], s);
  position_.resize(factor_->n);
  for (int i = 0; i < static_cast<int>(factor_->n); ++i) position_[count(integers(factor_->Perm)[i])] = i;
  std::vector<int> parents;
  std::vector<double> work;
  for (int s = 0; s < static_cast<int>(factor_->nsuper) && count(super_[s]) < eliminated_; ++s) {
    parents.push_back(parent_of(s));
    work.push_back(entries_of(s));
  }
  whole_ = EliminationOrder(parents, work);
}

CholmodMatrix::Supernode CholmodMatrix::supernode(int s) const {
  const int* start = integers(factor_->pi);
  return {super_[s], size_of(s), start[s + 1] - start[s], reals(factor_->x) + integers(factor_->px)[s],
          integers(factor_->s) + start[s]};
}

int CholmodMatrix::parent_of(int s) const {
  const Supernode node = supernode(s);
  if (node.rows == node.size || count(node.row[node.size]) >= eliminated_) return -1;
  return supernode_of_[count(node.row[node.size])];
}

double CholmodMatrix::entries_of(int s) const {
  const Supernode node = supernode(s);
  return static_cast<double>(node.rows) * node.size;
}

std::vector<int> CholmodMatrix::way_of(std::span<const BlockId> blocks) const {
  std::set<int> out;
  for (const BlockId block : blocks) {
    const int* rows = position_.data() + block_unknowns * block.value();
    const int first = *std::min_element(rows, rows + block_unknowns);
    int s = count(first) < eliminated_ ? supernode_of_[count(first)] : -1;
    while (s >= 0 && out.insert(s).second) s = parent_of(s);
  }
  return {out.begin(), out.end()};
}

HalfSolution CholmodMatrix::half_solve(std::span<const Entry> entries) const {
  Eigen::MatrixXd none;
  return half_solve(entries, none);
}

HalfSolution CholmodMatrix::half_solve(std::span<const Entry> entries, Eigen::MatrixXd& rest) const {
  std::vector<BlockId> blocks;
  HalfSolution out;
  for (const Entry& entry : entries) {
    blocks.push_back(entry.block);
    out.columns = std::max(out.columns, 2 * entry.pair + 2);
  }
  out.parts = way_of(blocks);
  Eigen::Map<Eigen::MatrixXd> x = scratch(factor_->n, out.columns);
  for (const Entry& entry : entries)
    for (int i = 0; i < block_unknowns && block_unknowns * entry.block.value() < eliminated_; ++i)
      x.block<1, 2>(position_[block_unknowns * entry.block.value() + count(i)], 2 * entry.pair) +=
          entry.rows.row(i);
  Eigen::MatrixXd below;
  for (const int s : out.parts) {
    const Supernode node = supernode(s);
    const Entries l(node.values, node.rows, node.size, Eigen::OuterStride<>(node.rows));
    auto here = x.middleRows(node.first, node.size);
    l.topRows(node.size).triangularView<Eigen::Lower>().solveInPlace(here);
    const int more = node.rows - node.size;
    below.noalias() = l.bottomRows(more) * here;
    for (int i = 0; i < more; ++i) x.row(node.row[node.size + i]) -= below.row(i);
    for (const auto& row : here.rowwise()) out.values.insert(out.values.end(), row.begin(), row.end());
    here.setZero();
  }
  rest = x.bottomRows(static_cast<Eigen::Index>(num_border_rows()));
  x.bottomRows(rest.rows()).setZero();
  return out;
}

Eigen::MatrixXd CholmodMatrix::product(const HalfSolution& left, const HalfSolution& right) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(left.columns, right.columns);
  // The ways meet somewhere and are one from there to the root: walk back from it.
  auto i = left.parts.size(), j = right.parts.size();
  const double *x = left.values.data() + left.values.size(), *y = right.values.data() + right.values.size();
  while (i > 0 && j > 0) {
    Eigen::Index rows = 0;
    for (; i > 0 && j > 0 && left.parts[i - 1] == right.parts[j - 1]; --i, --j)
      rows += size_of(left.parts[i - 1]);
    x -= rows * left.columns;
    y -= rows * right.columns;
    add_product({x, rows, left.columns}, {y, rows, right.columns}, out);
    for (; i > 0 && j > 0 && left.parts[i - 1] > right.parts[j - 1]; --i)
      x -= left.columns * size_of(left.parts[i - 1]);
    for (; i > 0 && j > 0 && right.parts[j - 1] > left.parts[i - 1]; --j)
      y -= right.columns * size_of(right.parts[j - 1]);
  }
  return out;
}

void CholmodMatrix::add(const HalfSolution& y, Eigen::Index first, const Eigen::VectorXd& s,
                        std::span<double> sum) const {
  const double* values = y.values.data();
  for (const int part : y.parts) {
    const int size = size_of(part);
    Eigen::Map<Eigen::VectorXd>(sum.data() + super_[part], size).noalias() +=
        RowMajorMap(values, size, y.columns).middleCols(first, s.size()) * s;
    values += y.columns * size;
  }
}

void CholmodMatrix::complete(std::span<double> sums, int columns) const {
  Eigen::Map<Eigen::MatrixXd> x(sums.data(), static_cast<Eigen::Index>(factor_->n), columns);
  whole_.from_the_root([&](int s) { complete_supernode(s, x); });
  for (int c = 0; c < columns; ++c) to_blocks(sums.subspan(count(c) * factor_->n, factor_->n));
}

void CholmodMatrix::complete_supernode(int s, Eigen::Map<Eigen::MatrixXd>& x) const {
  const Supernode node = supernode(s);
  const Entries l(node.values, node.rows, node.size, Eigen::OuterStride<>(node.rows));
  const int more = node.rows - node.size;
  thread_local Eigen::VectorXd below;
  below.resize(more);
  for (Eigen::Index c = 0; c < x.cols(); ++c) {
    for (int i = 0; i < more; ++i) below[i] = x(node.row[node.size + i], c);
    auto here = x.col(c).segment(node.first, node.size);
    here.noalias() -= l.bottomRows(more).transpose() * below;
    l.topRows(node.size).triangularView<Eigen::Lower>().transpose().solveInPlace(here);
  }
}

void CholmodMatrix::to_blocks(std::span<double> x) const {
  std::vector<double>& out = turned_;
  out.resize(x.size());
  constexpr std::size_t grain = 50'000;
  parallel_for(x.size(), grain, [&](std::size_t i) { out[i] = x[count(position_[i])]; });
  parallel_for(x.size(), grain, [&](std::size_t i) { x[i] = out[i]; });
}

void CholmodMatrix::solve(std::span<double> x, int columns) const { apply(CHOLMOD_A, x, columns); }

void CholmodMatrix::apply(int system, std::span<double> x, int columns) const {
  cholmod_dense right{};
  right.nrow = right.d = factor_->n;
  right.ncol = count(columns);
  right.nzmax = x.size();
  right.x = x.data();
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_solve2(system, factor_, &right, nullptr, &work_[0], nullptr, &work_[1], &work_[2], &common_);
  check("solve");
  std::copy_n(reals(work_[0]->x), x.size(), x.begin());
}

void CholmodMatrix::check(const char* what) const {
  if (common_.status < CHOLMOD_OK)
    throw std::runtime_error("CHOLMOD could not " + std::string(what) + ": status " +
                             std::to_string(common_.status) +
                             (common_.status == CHOLMOD_OUT_OF_MEMORY ? ", out of memory" : ""));
}

}  // namespace dda
