#pragma once

#include <nlohmann/json.hpp>

#include "continuation/handover/handover.hpp"
#include "framework/files/run/run_folder.hpp"
#include "studies/dda/case/simulation.hpp"

namespace dda {

/// What a motion came to.
struct MotionRecord {
  Ending ending;
  nlohmann::ordered_json summary;
};

/// How a motion begins and what it shows.
struct MotionOptions {
  bool quiet = false;
  bool goes_on = false;  ///< where an earlier one of the same deck was killed or interrupted
};

/// Lets go what a path has left, and writes the folder `motion` inside that of the run:
///
///     motion.csv         energies and steps over time, a row per step, units beside it
///     fields, run.xdmf   the blocks at times, as ParaView plays them
///     energies.svg       where the energy has gone
///     end.svg            the blocks at the end, at their true places
///     restart.h5         from which a motion that was killed or interrupted goes on with the same bits
MotionRecord run_motion(const RunFolder& folder, const Simulation& simulation, const PathEnd& end,
                        const MotionOptions& options);

/// The folder of a motion, if there is one, into another run folder. Throws OutputError.
void copy_motion(const std::filesystem::path& from, const RunFolder& to);

}  // namespace dda
