#include "continuation/follow/place_before.hpp"

#include <algorithm>

namespace dda {

PlaceBefore::PlaceBefore(const PathState& path)
    : here_(path.walker.here()),
      leaving_(path.walker.leaving()),
      effort_(path.walker.effort()),
      memory_(path.memory),
      control_(path.control->memory()) {}

void PlaceBefore::go_back(PathState& path) const {
  Effort effort = path.walker.effort();
  for (int Effort::*count : {&Effort::accepted, &Effort::cracked_steps, &Effort::whole_steps})
    effort.*count = effort_.*count;
  path.walker.restore(here_, effort, leaving_);
  path.memory = memory_;
  path.control->restore(control_);
}

bool PlaceBefore::is_at_rest() const {
  return here_.state.load_factor == 0 &&
         std::ranges::all_of(here_.state.d.all(), [](double u) { return u == 0; });
}

}  // namespace dda
