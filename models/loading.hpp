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
};

/// The stages as Loading: forces before a stage are dead in it; offsets of initial stress; reactions and
/// gauges. A model without stages has one of no load.
std::vector<Loading> make_stages(const Structure& structure, const LoadProgramme& programme,
                                 Findings& findings);

}  // namespace dda
