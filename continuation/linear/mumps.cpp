#include <dmumps_c.h>
#include <mpi.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "continuation/linear/direct_solver.hpp"

namespace dda {
namespace {

struct MumpsParameters {};

/// MUMPS, LDLᵀ of the lower triangle (sym = 2): indefinite matrices and their inertia. One rank.
class Mumps final : public DirectSolver {
 public:
  Mumps() {
    id_.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
    id_.par = 1;
    id_.sym = 2;
    call(job_initialise);
    for (const int stream : {0, 1, 2, 3}) id_.icntl[stream] = stream == 3 ? 0 : -1;  // silent
  }
  ~Mumps() override { call(job_end); }

  bool factor(const BlockMatrix& a) override {
    const bool new_pattern = set_matrix(a);
    if (new_pattern) call(job_analyse);
    return call(job_factor);
  }

  void solve(std::span<double> x, int columns) override {
    id_.rhs = x.data();
    id_.nrhs = columns;
    id_.lrhs = id_.n;
    if (!call(job_solve))
      throw std::runtime_error("MUMPS could not solve: INFOG(1) = " + std::to_string(id_.infog[0]));
  }

  double factor_flops() const override { return id_.rinfog[2]; }
  int num_negative_pivots() const override { return id_.infog[11]; }

 private:
  static constexpr int job_initialise = -1, job_end = -2, job_analyse = 1, job_factor = 2, job_solve = 3;

  /// Copies the lower triangle into triplets; true when the pattern differs from the last one.
  bool set_matrix(const BlockMatrix& a) {
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
    const bool changed = rows != rows_ || columns != columns_;
    if (changed) {
      rows_ = std::move(rows);
      columns_ = std::move(columns);
    }
    id_.n = static_cast<MUMPS_INT>(6 * a.num_rows());
    id_.nnz = static_cast<MUMPS_INT8>(rows_.size());
    id_.irn = rows_.data();
    id_.jcn = columns_.data();
    id_.a = values_.data();
    return changed;
  }

  /// Enlarges the workspace when MUMPS asks for it; false when the matrix is singular.
  bool call(int job) {
    for (;;) {
      id_.job = job;
      dmumps_c(&id_);
      const int error = id_.infog[0];
      if (error >= 0) return true;
      constexpr int workspace_too_small = -9, other_workspace_too_small = -8, singular = -10;
      if ((error == workspace_too_small || error == other_workspace_too_small) && id_.icntl[13] < 1000) {
        id_.icntl[13] = 2 * id_.icntl[13];
        continue;
      }
      if (error == singular) return false;
      throw std::runtime_error("MUMPS failed: INFOG(1) = " + std::to_string(error) +
                               ", INFOG(2) = " + std::to_string(id_.infog[1]));
    }
  }

  DMUMPS_STRUC_C id_{};
  std::vector<MUMPS_INT> rows_, columns_;
  std::vector<double> values_;
};

Schema<MumpsParameters> schema() {
  return Schema<MumpsParameters>("Multifrontal LDLT factorisation (MUMPS) with the machine's BLAS.");
}

std::unique_ptr<DirectSolver> make(const MumpsParameters&) { return std::make_unique<Mumps>(); }

}  // namespace

DDA_REGISTER(direct_solvers(), "mumps", schema(), make);

}  // namespace dda
