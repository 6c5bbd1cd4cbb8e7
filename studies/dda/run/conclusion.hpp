#pragma once

#include "studies/dda/run/motion_run.hpp"
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

/// Whether load factor, load and energies are numbers.
bool is_finite(const Candidate& at);
/// Why a path ends where they are none.
inline constexpr auto out_of_range =
    "the numbers of the next step are too large or too small to compute with";

}  // namespace dda
