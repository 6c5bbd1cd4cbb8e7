#include "continuation/follow/judge.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/rung/rungs.hpp"

namespace dda {

std::optional<Outcome> refine_coarse(PathState& path, const Candidate& candidate, Stride& stride) {
  if (!is_coarse(path, candidate)) return {};
  if (stride.refinements++ < most_refinements) {
    if (!path.walker.leaving().dissipates && stride.refinements > 1)
      if (auto point = land_on_contact_change(path, stride.amount, stride.move.kind))
        return Outcome{std::move(point)};
    if (auto point = snap(path, candidate, stride)) return Outcome{std::move(point)};
    return shorten(path, stride, "the step leaves too much energy unaccounted for", 0.5);
  }
  if (!refuse_jump(path, candidate, to_string(stride.move.kind))) return {};
  stride.why = path.refusal;
  stride.amount *= path.parameters.step.cut;
  return Outcome{};
}

}  // namespace dda
