#pragma once

#include "framework/files/run/run_folder.hpp"
#include "studies/dda/case/simulation.hpp"

namespace dda {

/// paraview_state.py, which opens run.xdmf in ParaView (File > Load State): blocks by their larger principal stress, cracks by
/// their opening, displacements enlarged by `scale`, load factor and load of each step, names of the regions. It finds the run
/// beside itself; where ParaView does not say where that is, where the folder was.
void write_paraview_state(const RunFolder& folder, const Simulation& simulation, double scale);

}  // namespace dda
