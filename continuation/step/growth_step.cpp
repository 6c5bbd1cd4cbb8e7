#include <fmt/format.h>

#include <cmath>

#include "continuation/follow/trial.hpp"
#include "continuation/step/cuts.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

constexpr double at_strength = 1 - 1e-6;

/// The equilibrium with these cuts, damage as it is, whose first point stands at its strength.
std::optional<Candidate> settled(PathState& path) {
  Walker& walker = path.walker;
  const auto equation = make_event_equation(walker.system());
  const Attempt tried = walker.attempt(*equation, 1, walker.state(), Thoroughness::full);
  if (!tried.converged) {
    path.refusal = tried.reason;
    return {};
  }
  Candidate out =
      walker.settled({tried.state, walker.system().next_history(tried.state), tried.newton_iterations});
  out.solution = tried.solution;
  constexpr double far = 0.2;  // of the largest load
  const double moved = std::abs(path.load_of(out.state) - path.load_of(walker.state()));
  if (moved <= far * path.memory.peak_load) return out;
  path.refusal = fmt::format("the load would jump by {:.2g} of its peak", moved / path.memory.peak_load);
  return {};
}

std::string place(const Vec2& x) { return fmt::format("({:.6g}, {:.6g})", x.x(), x.y()); }

}  // namespace

std::optional<int> crack_to_grow(PathState& path) {
  if (!path.cracks) return {};
  System& system = path.walker.system();
  const auto laws = system.laws_at(path.walker.state());
  std::optional<int> out;
  double most = at_strength;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (!point.is_awaited) continue;
    const double opening =
        point.law->equivalent_opening(laws->opening[p], system.history()[p], point.stiffness);
    if (const double share = opening / system.kappa(p); share >= most) {
      most = share;
      out = path.cracks->structure.front().geometry().cuts()[*point.cut].crack;
    }
  }
  return out;
}

std::optional<Point> growth_step(PathState& path, int crack) {
  CrackFront& front = path.cracks->structure.front();
  const std::vector<Cut> cuts = front.geometry().cuts();
  const std::vector<CrackFront::Memory> memory = front.memory();
  const bool is_aimed = front.aim(crack, around(path));
  if (!is_aimed) front.grow(crack);
  follow_cuts(path, cuts);
  path.report(
      is_aimed ? "aimed" : "grown",
      is_aimed ? fmt::format("crack {} is aimed anew from {}", crack, place(front.tip(crack)))
      : front.end_of(crack).empty()
          ? fmt::format("crack {} has grown to {}", crack, place(front.tip(crack)))
          : fmt::format("crack {} ends at {}: {}", crack, place(front.tip(crack)), front.end_of(crack)));
  auto next = settled(path);
  if (!next) next = standing_still(path);
  if (next) {
    const double step = path.memory.step;
    constexpr double of_cuts = 1e-3;  // a closed cut that is taken back was not rigid
    auto point = jump_to(path, *std::move(next), StepKind::growth, of_cuts * path.walker.here().stored);
    path.memory.step = step;
    if (point) return point;
  }
  const std::vector<Cut> refused = front.geometry().cuts();
  front.restore(cuts, memory);
  follow_cuts(path, refused);
  return path.end(
      Ending::Kind::stopped_early,
      fmt::format("no equilibrium was found next to the last one once the crack at {} had grown: {}",
                  place(front.tip(crack)), path.refusal));
}

}  // namespace dda
