#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "framework/output/curve_table.hpp"
#include "studies/simulation.hpp"

namespace dda {

/// Lowest eigenvalues of the physical tangent stiffness at accepted states, and what tells stable from
/// unstable.
///
///     K* φ = μ M φ            K* with the stiffness p̄ of joints whose k is a device of the iteration, points
///                             on their damage surface loading
///     n₋                      negative eigenvalues of K*: 0 where the state is stable under dead load
///     S = (ṗ/u̇)/(ṗ/u̇)₀        current stiffness of the path (Bergan), p the load and u the displacement on
///     which
///                             it works: 1 at the start, 0 at a limit point, negative while the load falls
///                             and u grows, infinite where u turns back, positive while both fall
///
/// Friction makes K* unsymmetric: the eigenvalues are then those of its symmetric part. Columns of steps
/// without eigenvalues hold nan, as do those where they do not converge. Source: Pearce et al. (2000),
/// section 6.
class FailureIndicator {
 public:
  /// `first_stiffness` is ṗ/u̇ at the start of a run that is continued, 0 for a new one.
  FailureIndicator(Simulation& simulation, const EigenvalueParameters& parameters, double first_stiffness);

  /// `current_stiffness`, and where eigenvalues are asked for `negative_eigenvalues`, `mu_1` … `mu_m`.
  std::vector<Column> columns() const;
  /// Those of the state at which the walker stands; the first call gives what the current stiffness is
  /// relative to.
  std::vector<TableCell> cells(int step);
  double first_stiffness() const { return first_stiffness_; }

 private:
  double path_stiffness() const;
  void append_eigenvalues(std::vector<TableCell>& out);

  Simulation& simulation_;
  EigenvalueParameters parameters_;
  std::vector<Mat6> mass_;
  double first_stiffness_;
};

}  // namespace dda
