#include "continuation/linear/direct/direct_solver.hpp"
#include "continuation/linear/direct/mumps_matrix.hpp"

namespace dda {
namespace {

struct MumpsParameters {};

/// MUMPS, LDLᵀ of the lower triangle (sym = 2): indefinite matrices and their inertia. One rank.
class Mumps final : public DirectSolver {
 public:
  bool factor(const BlockMatrix& a) override {
    matrix_.set(a);
    return matrix_.factor();
  }
  void solve(std::span<double> x, int columns) override { matrix_.solve(x, columns); }
  double factor_bytes(const BlockMatrix& a) override { return matrix_.factor_bytes(a); }
  double factor_flops() const override { return matrix_.flops(); }
  int num_negative_pivots() const override { return matrix_.count(12); }

 private:
  MumpsMatrix matrix_;
};

Schema<MumpsParameters> schema() {
  return Schema<MumpsParameters>("Multifrontal LDLT factorisation (MUMPS) with the machine's BLAS.");
}

std::unique_ptr<DirectSolver> make(const MumpsParameters&) { return std::make_unique<Mumps>(); }

}  // namespace

DDA_REGISTER(direct_solvers(), "mumps", schema(), make);

}  // namespace dda
