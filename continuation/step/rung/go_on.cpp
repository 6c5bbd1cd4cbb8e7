#include <algorithm>

#include "continuation/follow/branch.hpp"
#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> go_on(PathState& path, const Candidate& candidate, Stride& stride) {
  if (stride.beyond > 0) {  // how far away a strength was is no measure of the path
    path.memory.step = stride.beyond * unit_of(path, stride.move);
    path.memory.step_kind = stride.move.kind;
  } else {
    resize(path, candidate, stride.amount, stride.move);
  }
  note_looks(path, stride.looked, candidate);
  path.memory.step = std::max(path.memory.step, stride.looked_at);  // what was hidden is behind
  return Outcome{keep(path, candidate, stride.move.kind)};
}

}  // namespace dda
