#pragma once

#include "studies/dda/run/recording/run_recorder.hpp"

namespace dda {

/// The next accepted point of a path, recorded where there is a recorder; nothing at the end, of which `ending` then tells. A
/// point whose load factor, load or energies are no numbers ends the path before it.
std::optional<Point> next_point(Simulation& simulation, RunRecorder* recorder, Ending& ending);

}  // namespace dda
