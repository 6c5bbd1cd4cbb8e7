#include <optional>

#include "continuation/linear/direct/cholmod_matrix.hpp"
#include "continuation/linear/direct/direct_solver.hpp"
#include "continuation/linear/direct/mumps_matrix.hpp"

namespace dda {
namespace {

struct CholmodParameters {};

/// CHOLMOD as long as the matrix is positive definite, which intact structures without exact multipliers are;
/// MUMPS where it is not. One rank.
class Cholmod final : public DirectSolver {
 public:
  bool factor(const BlockMatrix& a) override {
    const bool may_be_definite = a.num_leading() == a.num_rows();
    is_definite_ = may_be_definite && definite_.factor(a);
    if (is_definite_) {
      indefinite_.reset();
      return true;
    }
    definite_.forget();
    if (!indefinite_) indefinite_.emplace();
    indefinite_->set(a);
    return indefinite_->factor();
  }

  void solve(std::span<double> x, int columns) override {
    if (is_definite_)
      definite_.solve(x, columns);
    else
      indefinite_->solve(x, columns);
  }

  double factor_bytes(const BlockMatrix& a) override {
    is_definite_ = a.num_leading() == a.num_rows();
    if (is_definite_) return definite_.factor_bytes(a);
    if (!indefinite_) indefinite_.emplace();
    return indefinite_->factor_bytes(a);
  }
  double factor_flops() const override {
    return is_definite_ ? definite_.factor_flops() : indefinite_->flops();
  }
  int num_negative_pivots() const override { return is_definite_ ? 0 : indefinite_->count(12); }
  const HalfSolver* halves() const override { return is_definite_ ? &definite_ : nullptr; }

 private:
  CholmodMatrix definite_;
  std::optional<MumpsMatrix> indefinite_;
  bool is_definite_ = false;
};

Schema<CholmodParameters> schema() {
  return Schema<CholmodParameters>(
      "Supernodal Cholesky factorisation (CHOLMOD); MUMPS wherever the matrix is not positive definite.");
}

std::unique_ptr<DirectSolver> make(const CholmodParameters&) { return std::make_unique<Cholmod>(); }

}  // namespace

DDA_REGISTER(direct_solvers(), "cholmod", schema(), make);

}  // namespace dda
