#include <fmt/format.h>

#include "continuation/follow/place_before.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/cuts.hpp"
#include "continuation/step/steps.hpp"

namespace dda {

std::optional<CrackFront::Asked> crack_to_start(PathState& path) {
  if (!path.cracks || !path.cracks->structure.front().is_automatic()) return {};
  CrackFront& front = path.cracks->structure.front();
  if (path.walker.here().dissipated == 0)
    return path.walker.leaving().d.empty() ? std::nullopt : front.asked_sooner(growing_stress(path));
  return front.asked(block_stress(path), spent_on(path, path.walker.here().history));
}

std::optional<Point> start_step(PathState& path, const CrackFront::Asked& asked) {
  CrackFront& front = path.cracks->structure.front();
  const PlaceBefore before(path);
  if (path.cracks->grows) path.cracks->grows();
  const std::vector<Cut> cuts = front.geometry().cuts();
  const std::vector<CrackFront::Memory> memory = front.memory();
  const auto crack = front.start(asked);
  if (!crack) return {};
  follow_cuts(path, cuts);
  const Vec2& x = front.tip(*crack);
  const auto said = [&] {
    path.report("begun", fmt::format("crack {} {} ({:.6g}, {:.6g})", *crack,
                                     asked.moved ? "moves to" : "stands ready at", x.x(), x.y()));
  };
  if (before.is_at_rest()) {
    path.walker.begin_stage(path.walker.system().equilibrium().stages().size() - 1);
    said();
    return {};
  }
  path.refusal = "no convergence with the cut closed";
  if (auto next = standing_still(path)) {
    constexpr double of_cuts = 1e-3;  // a closed cut is all but rigid
    const double step = path.memory.step;
    auto point = jump_to(path, *std::move(next), StepKind::growth, of_cuts * path.walker.here().stored);
    path.memory.step = step;
    if (point) {
      said();
      return point;
    }
  }
  const std::vector<Cut> refused = front.geometry().cuts();
  front.restore(cuts, memory);
  follow_cuts(path, refused);
  return path.stop_early(
      Stop::crack_grown,
      fmt::format("no equilibrium was found once a crack stood ready at ({:.6g}, {:.6g}): {}",
                  asked.start.at.x(), asked.start.at.y(), path.refusal));
}

}  // namespace dda
