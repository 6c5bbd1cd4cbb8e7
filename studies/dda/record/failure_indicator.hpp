#pragma once

#include <set>
#include <vector>

#include "continuation/stability/mode_tracker.hpp"
#include "studies/dda/case/simulation.hpp"
#include "studies/dda/record/recorded_column.hpp"

namespace dda {

/// M of K φ = μ M φ, of blocks and jumps; an identity has none of what a jump's node does not use either.
Mass mass_for(const Simulation& simulation, EigenvalueMass kind);

/// What an indicator remembers; a restart brings it back.
struct IndicatorMemory {
  double first_stiffness = 0;  ///< ṗ/u̇ at the start; 0 before it
  TrackedModes modes;
  int spare_modes = 0;  ///< computed beyond those asked for, once a tracked one was lost among them
};

/// Lowest eigenvalues of the physical stiffness at accepted states, and what tells stable from unstable.
///
///     K* φ = μ M φ            K* with the stiffness p̄ of joints whose k is a device of the iteration, points
///                             on their damage surface loading, nothing left of released points
///     n₋                      negative eigenvalues of the path's stiffness: 0 where the state is stable
///                             under dead load; those that are left while the control holds what it
///                             prescribes; and those of its symmetric part
///     S = (ṗ/u̇)/(ṗ/u̇)₀        current stiffness of the path (Bergan), p the load and u the displacement on
///                             which it works: 1 at the start, 0 at a limit point, negative while the load
///                             falls and u grows, infinite where u turns back, positive while both fall
///
/// Modes are tracked from the start (ModeTracker): the ratio μ/μ₀ belongs to a shape, not to a place in the
/// order. A mode counts as rigid when only weak springs oppose it, |μ| ≤ 10 φᵀ K_w φ beyond rounding. Columns
/// of steps without eigenvalues hold nan, as do those where they do not converge and the ratios of modes that
/// are not among the lowest. Source: Pearce et al. (2000), section 6.
class FailureIndicator {
 public:
  FailureIndicator(Simulation& simulation, IndicatorMemory memory);

  /// They tell what it has looked at last.
  RecordedColumns columns() const;
  /// At the state at which the walker stands; the first look gives what ratios are relative to.
  void look(const RecordedStep& at);
  /// Cracks have grown: modes go on in the unknowns that there are now.
  void follow(const Growth& growth);
  /// A shape of before in them.
  std::vector<double> followed(const std::vector<double>& shape, const Growth& growth) const;
  const IndicatorMemory& memory() const { return memory_; }
  /// Shapes of the last look, in ascending order of μ; none when it computed none.
  const std::vector<std::vector<double>>& shapes() const { return shapes_; }

 private:
  bool is_due(const RecordedStep& at) const;
  double path_stiffness() const;
  Eigenmodes modes(int count);
  void find_eigenvalues();
  std::vector<double> ratios_of(const Eigenmodes& found);
  bool is_rigid(const Eigenmodes& found, std::size_t mode) const;

  Simulation& simulation_;
  const EigenvalueParameters& parameters_;
  Mass mass_;
  IndicatorMemory memory_;
  ModeTracker tracker_;
  double stiffness_ = 1;  ///< over that at the start
  std::vector<double> values_, ratios_;
  std::optional<int> num_rigid_;
  std::vector<std::vector<double>> shapes_;
};

}  // namespace dda
