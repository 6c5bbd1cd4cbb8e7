#include <fmt/format.h>

#include <cmath>

#include "continuation/follow/trial.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

constexpr double at_strength = 1 - 1e-6;

/// σ of the block at a point.
CrackFront::Stress stress_around(PathState& path) {
  const State& at = path.walker.state();
  return [&path, d = at.d.all(), load_factor = at.load_factor](const Vec2& x) -> std::optional<Vec3> {
    const CrackedStructure& structure = path.cracks->structure;
    const auto blocks = structure.front().geometry().blocks_near(x);
    if (blocks.empty()) return {};
    const std::size_t b = blocks.front().value();
    const Eigen::Map<const Vec3> strain(d.data() + block_unknowns * b + 3);
    const Loading& loading = path.walker.system().loading();
    return Vec3(structure.body().material(blocks.front()).stiffness() * strain +
                loading.initial_stress(b, load_factor));
  };
}

/// Makes the structure anew for the cuts that there are now.
void follow(PathState& path, const std::vector<Cut>& before) {
  const RunningCracks& cracks = *path.cracks;
  const Growth growth = path.walker.follow([&] { return cracks.structure.remake(before); });
  path.look_up(cracks.look_up());
  if (cracks.has_grown) cracks.has_grown(growth);
}

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
  if (path.cracks->grows) path.cracks->grows();
  const std::vector<Cut> cuts = front.geometry().cuts();
  const std::vector<CrackFront::Memory> memory = front.memory();
  const bool is_aimed = front.aim(crack, stress_around(path));
  if (!is_aimed) front.grow(crack);
  follow(path, cuts);
  path.report(
      is_aimed ? "aimed" : "grown",
      is_aimed ? fmt::format("crack {} is aimed anew from {}", crack, place(front.tip(crack)))
      : front.end_of(crack).empty()
          ? fmt::format("crack {} has grown to {}", crack, place(front.tip(crack)))
          : fmt::format("crack {} ends at {}: {}", crack, place(front.tip(crack)), front.end_of(crack)));
  if (auto next = settled(path)) {
    const double step = path.memory.step;
    constexpr double of_cuts = 1e-3;  // a closed cut that is taken back was not rigid
    auto point = jump_to(path, *std::move(next), StepKind::growth, of_cuts * path.walker.here().stored);
    path.memory.step = step;
    if (point) return point;
  }
  const std::vector<Cut> refused = front.geometry().cuts();
  front.restore(cuts, memory);
  follow(path, refused);
  return path.end(
      Ending::Kind::stopped_early,
      fmt::format("no equilibrium was found next to the last one once the crack at {} had grown: {}",
                  place(front.tip(crack)), path.refusal));
}

}  // namespace dda
