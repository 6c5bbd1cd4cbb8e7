#include "continuation/linear/direct/mumps_matrix.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string>

#include "framework/base/loaded.hpp"

namespace dda {
namespace {

constexpr int job_initialise = -1, job_end = -2, job_analyse = 1, job_factor = 2, job_solve = 3;

/// MUMPS, loaded with the first matrix: most runs never meet an indefinite one.
void run_mumps(DMUMPS_STRUC_C& instance) {
  static const auto function =
      reinterpret_cast<decltype(&dmumps_c)>(symbol_of(module_file("dda_mumps.so"), "dda_mumps"));
  function(&instance);
}

}  // namespace

MumpsMatrix::MumpsMatrix(Symmetry symmetry) {
  id_.par = 1;
  id_.sym = static_cast<MUMPS_INT>(symmetry);
  call(job_initialise);
  for (const int stream : {1, 2, 3}) control(stream) = -1;  // silent
  control(4) = 0;
}

MumpsMatrix::~MumpsMatrix() { call(job_end); }

std::vector<std::size_t> MumpsMatrix::elimination_of(const BlockMatrix& a) {
  const std::size_t leading = a.num_leading();
  MumpsMatrix graph;
  for (std::size_t r = 0; r < leading; ++r)
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1] && a.columns()[s] <= r; ++s) {
      graph.rows_.push_back(static_cast<MUMPS_INT>(r + 1));
      graph.columns_.push_back(static_cast<MUMPS_INT>(a.columns()[s] + 1));
    }
  graph.values_.assign(graph.rows_.size(), 1.0);
  graph.point_at(leading);
  graph.control(12) = 1;  // ordered as a graph, whatever the values
  graph.call(job_analyse);
  std::vector<std::size_t> at(leading), out(a.num_rows());
  for (std::size_t r = 0; r < leading; ++r) at[static_cast<std::size_t>(graph.id_.sym_perm[r]) - 1] = r;
  std::size_t next = 0;
  std::vector<int> waits_for(a.num_rows(), -1);  // of a multiplier: for itself and its blocks
  for (std::size_t m = leading; m < a.num_rows(); ++m)
    waits_for[m] = static_cast<int>(a.row_start()[m + 1] - a.row_start()[m]) - 1;
  for (const std::size_t r : at) {
    out[r] = next++;
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s)
      if (const std::size_t m = a.columns()[s]; m >= leading && --waits_for[m] == 0) out[m] = next++;
  }
  return out;
}

void MumpsMatrix::set(const BlockMatrix& a) {
  std::vector<MUMPS_INT> rows, columns;
  values_.clear();
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s) {
      const std::size_t c = a.columns()[s];
      if (is_symmetric() && c > r) continue;
      for (int i = 0; i < block_unknowns; ++i)
        for (int j = 0; j < (is_symmetric() && c == r ? i + 1 : block_unknowns); ++j) {
          rows.push_back(static_cast<MUMPS_INT>(6 * r + i + 1));
          columns.push_back(static_cast<MUMPS_INT>(6 * c + j + 1));
          values_.push_back(a.value(s)(i, j));
        }
    }
  if (rows != rows_ || columns != columns_) {
    rows_ = std::move(rows);
    columns_ = std::move(columns);
    is_analysed_ = false;
    if (a.num_leading() < a.num_rows()) order_multipliers_last(a);
  }
  point_at(6 * a.num_rows());
}

void MumpsMatrix::point_at(std::size_t n) {
  id_.n = static_cast<MUMPS_INT>(n);
  id_.nnz = static_cast<MUMPS_INT8>(rows_.size());
  id_.irn = rows_.data();
  id_.jcn = columns_.data();
  id_.a = values_.data();
}

void MumpsMatrix::order_multipliers_last(const BlockMatrix& a) {
  position_.clear();
  for (const std::size_t row : elimination_of(a))
    for (std::size_t i = 0; i < block_unknowns; ++i)
      position_.push_back(static_cast<MUMPS_INT>(6 * row + i + 1));
  id_.perm_in = position_.data();
  control(6) = 0;           // the rows stay in their places
  control(7) = 1;           // this elimination
  real_control(1) = 1e-10;  // -δ P is a good pivot, nothing smaller
}

double MumpsMatrix::factor_bytes(const BlockMatrix& a) {
  set(a);
  call(job_analyse);
  is_analysed_ = true;
  const double per_entry = 2 * sizeof(MUMPS_INT) + sizeof(double);
  return sizeof(double) * large_count(20) + per_entry * static_cast<double>(values_.size());
}

bool MumpsMatrix::factor() {
  if (!is_analysed_) call(job_analyse);
  is_analysed_ = is_factorised_ = true;
  return call(job_factor);
}

void MumpsMatrix::solve(std::span<double> x, int columns) {
  if (position_.empty()) return substitute(x, columns);
  const std::vector<double> right(x.begin(), x.end());
  substitute(x, columns);
  constexpr int refinements = 2;
  for (int i = 0; i < refinements; ++i) {
    std::vector<double> rest = right;
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c)
      subtract_product(x.data() + c * static_cast<std::size_t>(id_.n),
                       rest.data() + c * static_cast<std::size_t>(id_.n));
    substitute(rest, columns);
    std::ranges::transform(x, rest, x.begin(), std::plus{});
  }
}

void MumpsMatrix::substitute(std::span<double> x, int columns) {
  id_.rhs = x.data();
  id_.nrhs = columns;
  id_.lrhs = id_.n;
  if (!call(job_solve))
    throw std::runtime_error("MUMPS could not solve: INFOG(1) = " + std::to_string(count(1)));
}

void MumpsMatrix::subtract_product(const double* x, double* y) const {
  for (std::size_t e = 0; e < values_.size(); ++e) {
    const auto row = rows_[e] - 1, column = columns_[e] - 1;
    y[row] -= values_[e] * x[column];
    if (is_symmetric() && row != column) y[column] -= values_[e] * x[row];
  }
}

bool MumpsMatrix::call(int job) {
  for (;;) {
    id_.job = job;
    run_mumps(id_);
    const int error = count(1);
    if (error >= 0) return true;
    constexpr int workspace_too_small = -9, other_workspace_too_small = -8, singular = -10;
    if ((error == workspace_too_small || error == other_workspace_too_small) && control(14) < 100000) {
      control(14) = 2 * control(14);
      continue;
    }
    if (error == singular) return false;
    throw std::runtime_error("MUMPS failed: INFOG(1) = " + std::to_string(error) +
                             ", INFOG(2) = " + std::to_string(count(2)));
  }
}

}  // namespace dda
