#pragma once

#include "continuation/course/path_state.hpp"

namespace dda {

/// Where a path stands, to go back to once a step from there turns out to have been taken in another structure than
/// it should have been. What was computed on the way stays counted, steps are not.
class PlaceBefore {
 public:
  explicit PlaceBefore(const PathState& path);
  void go_back(PathState& path) const;
  /// Whether the structure was at rest there, with neither loads nor displacements.
  bool is_at_rest() const;
  const std::vector<History>& history() const { return here_.history; }

 private:
  Candidate here_;
  Tangent leaving_;
  Effort effort_;
  PathMemory memory_;
  double control_;
};

}  // namespace dda
