#include "continuation/linear/mumps_matrix.hpp"

#include <mpi.h>

#include <stdexcept>
#include <string>

namespace dda {
namespace {

constexpr int job_initialise = -1, job_end = -2, job_analyse = 1, job_factor = 2, job_solve = 3;

}  // namespace

MumpsMatrix::MumpsMatrix() {
  id_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
  id_.par = 1;
  id_.sym = 2;
  call(job_initialise);
  for (const int stream : {1, 2, 3}) control(stream) = -1;  // silent
  control(4) = 0;
}

MumpsMatrix::~MumpsMatrix() { call(job_end); }

void MumpsMatrix::set(const BlockMatrix& a) {
  std::vector<MUMPS_INT> rows, columns;
  values_.clear();
  for (std::size_t r = 0; r < a.num_rows(); ++r)
    for (std::size_t s = a.row_start()[r]; s < a.row_start()[r + 1]; ++s) {
      const std::size_t c = a.columns()[s];
      if (c > r) continue;
      for (int i = 0; i < block_unknowns; ++i)
        for (int j = 0; j < (c == r ? i + 1 : block_unknowns); ++j) {
          rows.push_back(static_cast<MUMPS_INT>(6 * r + i + 1));
          columns.push_back(static_cast<MUMPS_INT>(6 * c + j + 1));
          values_.push_back(a.value(s)(i, j));
        }
    }
  if (rows != rows_ || columns != columns_) {
    rows_ = std::move(rows);
    columns_ = std::move(columns);
    is_analysed_ = false;
  }
  id_.n = static_cast<MUMPS_INT>(6 * a.num_rows());
  id_.nnz = static_cast<MUMPS_INT8>(rows_.size());
  id_.irn = rows_.data();
  id_.jcn = columns_.data();
  id_.a = values_.data();
}

bool MumpsMatrix::factor() {
  if (!is_analysed_) call(job_analyse);
  is_analysed_ = true;
  return call(job_factor);
}

void MumpsMatrix::solve(std::span<double> x, int columns) {
  id_.rhs = x.data();
  id_.nrhs = columns;
  id_.lrhs = id_.n;
  if (!call(job_solve))
    throw std::runtime_error("MUMPS could not solve: INFOG(1) = " + std::to_string(count(1)));
}

bool MumpsMatrix::call(int job) {
  for (;;) {
    id_.job = job;
    dmumps_c(&id_);
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
