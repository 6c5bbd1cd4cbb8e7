#include "continuation/modules/anasazi/krylov_schur.hpp"

#include <AnasaziBasicEigenproblem.hpp>
#include <AnasaziBlockKrylovSchurSolMgr.hpp>
#include <AnasaziTpetraAdapter.hpp>
#include <Tpetra_MultiVector.hpp>
#include <Tpetra_Operator.hpp>
#include <algorithm>
#include <random>
#include <stdexcept>

#include "continuation/modules/trilinos_session.hpp"

namespace dda {
namespace {

using MultiVector = Tpetra::MultiVector<double>;
using Operator = Tpetra::Operator<double>;
using Map = Tpetra::Map<>;

/// Y = A X column by column.
class ColumnOperator : public Operator {
 public:
  ColumnOperator(Teuchos::RCP<const Map> map, const EigenProblem& problem)
      : problem_(problem), map_(std::move(map)) {}

  Teuchos::RCP<const Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const Map> getRangeMap() const override { return map_; }
  void apply(const MultiVector& x, MultiVector& y, Teuchos::ETransp, double, double) const override {
    for (std::size_t c = 0; c < x.getNumVectors(); ++c) {
      const auto from = x.getData(c);
      const auto to = y.getDataNonConst(c);
      multiply({from.getRawPtr(), problem_.n()}, {to.getRawPtr(), problem_.n()});
    }
  }

 protected:
  virtual void multiply(std::span<const double> x, std::span<double> y) const = 0;
  const EigenProblem& problem_;

 private:
  Teuchos::RCP<const Map> map_;
};

class MassOperator final : public ColumnOperator {
 public:
  using ColumnOperator::ColumnOperator;
  void multiply(std::span<const double> x, std::span<double> y) const override {
    problem_.mass.multiply(x, y);
  }
};

/// (K + s M)⁻¹ M.
class ShiftInvert final : public ColumnOperator {
 public:
  ShiftInvert(const Teuchos::RCP<const Map>& map, const EigenProblem& problem, const InverseOperator& solve)
      : ColumnOperator(map, problem), mass_(map, problem), solve_(solve) {}
  void multiply(std::span<const double> x, std::span<double> y) const override {
    std::vector<double> right(x.size());
    mass_.multiply(x, right);
    solve_(right, y);
  }

 private:
  MassOperator mass_;
  const InverseOperator& solve_;
};

/// A start that is the same on every machine: without symmetry, so that no mode is orthogonal to it.
Teuchos::RCP<MultiVector> start(const Teuchos::RCP<const Map>& map, int vectors) {
  auto out = Teuchos::rcp(new MultiVector(map, static_cast<std::size_t>(vectors)));
  std::mt19937_64 random(1);
  constexpr double half = 9007199254740992.0;  // 2⁵³
  for (std::size_t c = 0; c < out->getNumVectors(); ++c)
    for (double& value : out->getDataNonConst(c)) value = static_cast<double>(random() >> 10) / half - 1;
  return out;
}

}  // namespace

Eigenmodes anasazi_krylov_schur(const EigenProblem& problem, const Search& search) {
  const int count = search.count;
  constexpr int block_size = 3;
  const auto map = Teuchos::rcp(new Map(problem.n(), 0, this_rank()));
  using Problem = Anasazi::BasicEigenproblem<double, MultiVector, Operator>;
  const auto eigen =
      Teuchos::rcp(new Problem(Teuchos::rcp(new ShiftInvert(map, problem, search.solve)),
                               Teuchos::rcp(new MassOperator(map, problem)), start(map, block_size)));
  eigen->setHermitian(true);
  eigen->setNEV(count);
  if (!eigen->setProblem()) throw std::runtime_error("Anasazi refuses the eigenvalue problem");
  Teuchos::ParameterList list;
  list.set("Which", "LM");
  list.set("Block Size", block_size);
  list.set("Num Blocks", std::max(8, (2 * count + block_size - 1) / block_size + 2));
  list.set("Maximum Restarts", 300);
  list.set("Convergence Tolerance", 1e-10);
  list.set("Verbosity", static_cast<int>(Anasazi::Errors));
  Anasazi::BlockKrylovSchurSolMgr<double, MultiVector, Operator> manager(eigen, list);
  if (manager.solve() != Anasazi::Converged)
    throw std::runtime_error("the eigenvalues of the stiffness did not converge");
  const auto& solution = eigen->getSolution();
  Eigenmodes out;
  for (int i = 0; i < std::min(count, solution.numVecs); ++i) {
    out.values.push_back(1 / solution.Evals[static_cast<std::size_t>(i)].realpart - search.shift);
    const auto shape = solution.Evecs->getData(static_cast<std::size_t>(i));
    out.shapes.emplace_back(shape.begin(), shape.end());
  }
  return out;
}

}  // namespace dda
