#pragma once

#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// Everything the loads of a deck become, stage by stage.
struct LoadProgramme {
  std::vector<StageLoads> stages;
  std::vector<Spring> driven;  ///< what any stage drives

  /// Of the springs of all supports those that stages take away, in the order in which they go.
  std::vector<ChangingSpring> removed(const std::vector<Spring>& supports) const;
};

/// What a stress that is there without strain does in joints: openings P⁻¹{σ0}n of the active points, and the force
/// Sᵀ W P⁻¹ {σ0}n that the subtracted energy exerts. `stress` is as StageLoads keeps it.
struct StressOffset {
  std::vector<double> openings, force;
};
StressOffset stress_offset(const Body& body, const InterfaceSet& set, const std::vector<Vec3>& stress);

/// Asks the loads of every stage for their forces; places outside the structure are findings.
LoadProgramme make_loads(const Body& body, const ModelParameters& model, Findings& findings);

/// Finds where supports, those that are there from first to last, hold what a load drives along the same direction.
void check_driven(const LoadProgramme& programme, const std::vector<Spring>& supports, Findings& findings);

/// What loads act on.
struct Structure {
  const Body& body;
  const ModelParameters& model;
  const InterfaceSet& interfaces;
  const std::vector<Spring>&all_supports, &supports;  ///< as described, and those that are there
  const std::vector<ChangingSpring>& removed;
  const StageHistory& history;
};

/// The stages as Loading.
struct StageLoadings {
  std::vector<Loading> begun;  ///< those applied in full, and behind them the one that is followed
  std::vector<Loading> later;  ///< with what is dead now
};

/// Forces before a stage are dead in it, those of followed stages at the load factors at which they are held; offsets
/// of initial stress; reactions and gauges. A model without stages has one of no load.
StageLoadings make_stages(const Structure& structure, const LoadProgramme& programme, Findings& findings);

}  // namespace dda
