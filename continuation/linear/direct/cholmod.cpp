#include <memory>
#include <optional>

#include "continuation/linear/cholesky/cholmod_matrix.hpp"
#include "continuation/linear/direct/direct_solver.hpp"
#include "continuation/linear/direct/mumps_matrix.hpp"
#include "continuation/linear/strips/shared_matrix.hpp"

namespace dda {
namespace {

struct CholmodParameters {};

/// CHOLMOD as long as the matrix is positive definite, which intact structures without exact multipliers are, on all
/// ranks of the run; MUMPS where it is not, on the first.
class Cholmod final : public DirectSolver {
 public:
  Cholmod() {
    if (Ranks* ranks = ranks_of_run()) shared_ = std::make_unique<SharedMatrix>(*ranks);
  }

  bool factor(const BlockMatrix& a) override {
    const bool may_be_definite = a.num_leading() == a.num_rows();
    is_definite_ = may_be_definite && (shared_ ? shared_->factor(a) : definite_.factor(a));
    if (is_definite_) {
      indefinite_.reset();
      return true;
    }
    forget_definite();
    if (!indefinite_) indefinite_.emplace();
    indefinite_->set(a);
    return indefinite_->factor();
  }

  void solve(std::span<double> x, int columns) override {
    if (!is_definite_)
      indefinite_->solve(x, columns);
    else if (shared_)
      shared_->solve(x, columns);
    else
      definite_.solve(x, columns);
  }

  double factor_bytes(const BlockMatrix& a) override {
    is_definite_ = a.num_leading() == a.num_rows();
    if (is_definite_) return shared_ ? shared_->bytes_here(a) : definite_.factor_bytes(a);
    if (!indefinite_) indefinite_.emplace();
    return indefinite_->factor_bytes(a);
  }
  double factor_flops() const override {
    if (!is_definite_) return indefinite_->flops();
    return shared_ ? shared_->factor_flops() : definite_.factor_flops();
  }
  int num_negative_pivots() const override { return is_definite_ ? 0 : indefinite_->count(12); }
  const HalfSolver* halves() const override {
    if (!is_definite_) return nullptr;
    return shared_ ? static_cast<const HalfSolver*>(shared_.get()) : &definite_;
  }

 private:
  void forget_definite() { shared_ ? shared_->forget() : definite_.forget(); }

  CholmodMatrix definite_;
  std::unique_ptr<SharedMatrix> shared_;
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
