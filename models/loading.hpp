#pragma once

#include "models/equilibrium.hpp"

namespace dda {

/// Everything the loads of a deck become, stage by stage.
struct LoadProgramme {
  std::vector<StageLoads> stages;
  std::vector<Spring> driven;  ///< every driven spring of every stage
};

/// What a stress that is there without strain does in joints: openings P⁻¹{σ0}n of the active points, and the force
/// Sᵀ W P⁻¹ {σ0}n that the subtracted energy exerts. `stress` is by block.
struct StressOffset {
  std::vector<double> openings, force;
};
StressOffset stress_offset(const Body& body, const InterfaceSet& set, const std::vector<Vec3>& stress);

/// Asks the loads of every stage for their forces; places outside the structure are findings.
LoadProgramme make_loads(const Body& body, const ModelParameters& model, Findings& findings);

/// What loads act on.
struct Structure {
  const Body& body;
  const ModelParameters& model;
  const InterfaceSet& interfaces;
  const std::vector<Spring>& supports;
  const std::vector<double>& held_load_factors;  ///< of the followed stages that are over
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
