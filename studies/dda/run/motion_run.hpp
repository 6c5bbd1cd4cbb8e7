#pragma once

#include <nlohmann/json.hpp>

#include "framework/files/run/run_folder.hpp"
#include "studies/dda/case/simulation.hpp"

namespace dda {

/// What a motion came to.
struct MotionRecord {
  Ending ending;
  nlohmann::ordered_json summary;
};

/// Lets go what the path has left, and writes the folder `motion` inside that of the run:
///
///     motion.csv      energies and steps over time, a row per step, units beside it
///     fields, run.xdmf   the blocks at times, as ParaView plays them
///     energies.svg    where the energy has gone
///     end.svg         the blocks at the end, at their true places
MotionRecord run_motion(const RunFolder& folder, Simulation& simulation, bool quiet);

}  // namespace dda
