#include "studies/failure_indicator.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "continuation/stability/eigenmodes.hpp"
#include "models/mass.hpp"
#include "studies/measures.hpp"

namespace dda {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Factorises a symmetric matrix that no update of the path's own gives.
class WholeMatrix {
 public:
  WholeMatrix(const DirectSolverChoice& choice, const BlockMatrix& k) : solver_(choice.make()) {
    is_regular_ = solver_->factor(k);
  }
  bool is_regular() const { return is_regular_; }
  int num_negative() const { return solver_->num_negative_pivots(); }
  void solve(std::span<const double> b, std::span<double> x) {
    std::ranges::copy(b, x.begin());
    solver_->solve(x, 1);
  }

 private:
  std::unique_ptr<DirectSolver> solver_;
  bool is_regular_ = false;
};

}  // namespace

FailureIndicator::FailureIndicator(Simulation& simulation, const EigenvalueParameters& parameters,
                                   double first_stiffness)
    : simulation_(simulation), parameters_(parameters), first_stiffness_(first_stiffness) {
  if (parameters_.count == 0) return;
  mass_.assign(simulation.equilibrium().num_nodes(), Mat6::Identity());
  if (parameters_.mass) std::ranges::copy(unit_mass(simulation.body()), mass_.begin());
}

std::vector<Column> FailureIndicator::columns() const {
  std::vector<Column> out{{"current_stiffness", ""}};
  if (parameters_.count == 0) return out;
  out.push_back({"negative_eigenvalues", ""});
  constexpr Dimension per_mass{1, -4}, raw = dimension::stiffness;
  const std::string unit = unit_of(parameters_.mass ? per_mass : raw, simulation_.deck().units);
  for (int i = 1; i <= parameters_.count; ++i) out.push_back({"mu_" + std::to_string(i), unit});
  return out;
}

/// Rate of the load over that of the displacement on which it works, along the path.
double FailureIndicator::path_stiffness() const {
  const Tangent& leaving = simulation_.walker().leaving();
  const Loading& loading = simulation_.loading();
  if (leaving.d.empty()) return unknown;
  double rate = std::inner_product(leaving.d.begin(), leaving.d.end(), loading.reference_work.begin(), 0.0);
  for (const WorkPair& pair : loading.driven) rate += leaving.rate(pair.displacement);
  return leaving.rate(loading.load) / rate;
}

std::vector<TableCell> FailureIndicator::cells(int step) {
  const double stiffness = path_stiffness();
  if (first_stiffness_ == 0) first_stiffness_ = stiffness;
  std::vector<TableCell> out{stiffness / first_stiffness_};
  if (parameters_.count == 0) return out;
  if (step % parameters_.every == 0) {
    append_eigenvalues(out);
  } else {
    out.resize(2 + static_cast<std::size_t>(parameters_.count), unknown);
  }
  return out;
}

void FailureIndicator::append_eigenvalues(std::vector<TableCell>& out) {
  System& system = simulation_.system();
  const auto scope = system.timings().measure("eigenvalues");
  const State& here = simulation_.walker().state();
  const std::size_t columns = 2 + static_cast<std::size_t>(parameters_.count);
  EigenProblem problem{.solve = {}, .shifted = {}, .mass = mass_, .count = parameters_.count};
  std::optional<WholeMatrix> whole;
  problem.shifted = [&](double s) -> InverseOperator {
    BlockMatrix k = system.stiffness(here);
    for (std::size_t b = 0; b < mass_.size(); ++b) k.add(BlockId{b}, BlockId{b}, s * mass_[b]);
    whole.emplace(simulation_.deck().path.linear, k);
    if (!whole->is_regular() || whole->num_negative() != 0) return {};
    return [&](auto b, auto x) { whole->solve(b, x); };
  };
  if (system.use_path_tangent(*system.laws_at(here.d, here.load_factor)))
    problem.num_negative = system.path_linear().num_negative_eigenvalues();
  if (problem.num_negative) {
    problem.solve = [&](auto b, auto x) { system.path_linear().solve(b, x); };
  } else {
    whole.emplace(simulation_.deck().path.linear, system.stiffness(here));
    if (!whole->is_regular()) return out.resize(columns, unknown);
    if (whole->num_negative() >= 0) problem.num_negative = whole->num_negative();
    problem.solve = [&](auto b, auto x) { whole->solve(b, x); };
  }
  out.emplace_back(problem.num_negative ? *problem.num_negative : unknown);
  try {
    for (const double value : lowest_eigenmodes(problem).values) out.emplace_back(value);
  } catch (const std::runtime_error&) {  // what the path has come to does not depend on them
    out.resize(2);
  }
  out.resize(columns, unknown);
}

}  // namespace dda
