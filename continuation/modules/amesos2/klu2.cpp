#include <Amesos2.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <algorithm>

#include "continuation/linear/direct/direct_solver.hpp"
#include "continuation/modules/mpi_start.hpp"
#include "continuation/modules/trilinos_session.hpp"

namespace dda {
namespace {

using Matrix = Tpetra::CrsMatrix<double>;
using Columns = Tpetra::MultiVector<double>;

/// Amesos2 with KLU2, unsymmetric LU. One rank only: on two or more it returns wrong solutions without a
/// word.
class Klu2 final : public DirectSolver {
 public:
  Klu2() { start_mpi(); }  // Amesos2 asks it for its ranks

  bool factor(const BlockMatrix& a) override {
    assemble(a);
    num_entries_ = matrix_->getNodeNumEntries();
    try {
      solver_ = Amesos2::create<Matrix, Columns>("KLU2", matrix_);
      solver_->symbolicFactorization().numericFactorization();
    } catch (const std::exception&) {
      return false;
    }
    return true;
  }

  void solve(std::span<double> x, int columns) override {
    const auto map = matrix_->getDomainMap();
    const std::size_t n = matrix_->getNodeNumRows();
    Columns right(map, static_cast<std::size_t>(columns)), left(map, static_cast<std::size_t>(columns));
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c)
      std::copy_n(x.data() + c * n, n, right.getDataNonConst(c).getRawPtr());
    solver_->setX(Teuchos::rcpFromRef(left));
    solver_->setB(Teuchos::rcpFromRef(right));
    solver_->solve();
    for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c)
      std::copy_n(left.getData(c).getRawPtr(), n, x.data() + c * n);
  }

  /// KLU2 counts nothing before it factorises: as many entries as A has, and A itself.
  double factor_bytes(const BlockMatrix& a) override {
    constexpr double matrices = 2, bytes_per_entry = sizeof(double) + sizeof(int);
    num_entries_ = block_unknowns * block_unknowns * a.num_stored();
    return matrices * bytes_per_entry * static_cast<double>(num_entries_);
  }
  double factor_flops() const override { return 2 * static_cast<double>(num_entries_) * fill_guess; }
  int num_negative_pivots() const override { return -1; }

 private:
  static constexpr double fill_guess = 300;  ///< operations per stored entry; KLU2 does not report them

  void assemble(const BlockMatrix& a) {
    const std::size_t n = 6 * a.num_rows();
    const auto map = Teuchos::rcp(new Tpetra::Map<>(n, 0, this_rank()));
    std::vector<std::size_t> lengths(n);
    for (std::size_t i = 0; i < n; ++i) lengths[i] = 6 * (a.row_start()[i / 6 + 1] - a.row_start()[i / 6]);
    matrix_ = Teuchos::rcp(
        new Matrix(map, map, Teuchos::ArrayView<const std::size_t>(lengths), Tpetra::StaticProfile));
    for (std::size_t i = 0; i < n; ++i) insert_row(a, i);
    matrix_->fillComplete();
  }

  void insert_row(const BlockMatrix& a, std::size_t i) {
    std::vector<int> columns;
    std::vector<double> values;
    for (std::size_t s = a.row_start()[i / 6]; s < a.row_start()[i / 6 + 1]; ++s)
      for (std::size_t j = 0; j < 6; ++j) {
        columns.push_back(static_cast<int>(6 * a.columns()[s] + j));
        values.push_back(a.value(s)(static_cast<Eigen::Index>(i % 6), static_cast<Eigen::Index>(j)));
      }
    matrix_->insertLocalValues(static_cast<int>(i), columns, values);
  }

  std::size_t num_entries_ = 0;
  Teuchos::RCP<Matrix> matrix_;
  Teuchos::RCP<Amesos2::Solver<Matrix, Columns>> solver_;
};

}  // namespace
}  // namespace dda

/// What continuation/linear/direct/amesos2.cpp loads; the caller owns it.
extern "C" dda::DirectSolver* dda_klu2() {
  static const dda::TrilinosSession session;
  return new dda::Klu2;
}
