#pragma once

#include "studies/dda/run/motion/motion_run.hpp"
#include "studies/dda/run/run.hpp"

namespace dda {

/// A path that has been followed and recorded.
struct FollowedPath {
  const DeckFile& deck;
  const RunFolder& folder;
  Simulation& simulation;
  RunRecorder& recorder;
};

/// What comes after a path, in this order: the branch that it has left, in a folder inside; the motion of what is let go;
/// last fields, figures and the summary. Throws OutputError.
RunResult conclude_run(const FollowedPath& followed, Ending ending, const MotionOptions& options);

}  // namespace dda
