#include "continuation/step/cuts.hpp"

#include <algorithm>
#include <numeric>

#include "continuation/solve/held_equilibrium.hpp"
#include "models/body/motion.hpp"
#include "models/load/eigenstress.hpp"

namespace dda {
namespace {

/// Takes traction and stiffness from those points of some cuts that are under tension: others stay closed.
void release(const Equilibrium& equilibrium, const std::vector<Cut>& cuts, std::span<const Cut> free,
             LawValues& laws) {
  for (std::size_t p = 0; p < laws.traction.size(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    if (!point.cut || !(laws.traction[p].x() > 0)) continue;
    if (std::ranges::none_of(free, [&](const Cut& cut) { return cut.is_at(cuts[*point.cut]); })) continue;
    laws.traction[p].setZero();
    laws.tangent[p].setZero();
  }
}

/// Holds the opening of every point that still bears traction: what a way beside them would gain by closing them again,
/// along their soft secants, is no energy of its own.
void hold(const System& system, LawValues& laws) {
  for (std::size_t p = 0; p < laws.tangent.size(); ++p)
    if (!system.is_broken(p)) laws.tangent[p] = system.equilibrium().point(p).intact_stiffness().asDiagonal();
}

double released_energy(PathState& path, const std::vector<Cut>& before, std::span<const Cut> free) {
  const CrackedStructure& structure = path.cracks->structure;
  const auto [equilibrium, growth] = structure.tried(before);
  System system(equilibrium, path.parameters.linear, path.parameters.update);
  system.set_stage(equilibrium.stages().size() - 1);
  system.set_history(growth.of_points(path.walker.system().history()));
  system.set_frozen(true);
  const State& here = path.walker.state();
  const State at{growth.unknowns(here.d.all()), here.load_factor};
  LawValues laws = system.laws(at);
  hold(system, laws);
  release(equilibrium, structure.front().geometry().cuts(), free, laws);
  std::vector<double> r(at.d.size()), moved(at.d.size());
  system.residual(at.d.all(), at.load_factor, laws, r);
  if (!system.use_tangent(system.new_stamp(), laws.tangent)) return 0;
  system.linear().solve(r, moved);
  return std::inner_product(r.begin(), r.end(), moved.begin(), 0.0) / 2;
}

}  // namespace

std::optional<Candidate> standing_still(PathState& path) {
  Walker& walker = path.walker;
  const Functional load_factor{.rows = {}, .per_load_factor = 1};
  const Functional& still = path.memory.peak_load > 0 ? path.displacement : load_factor;
  HeldEquilibrium held(walker.stepper(), still, walker.value(still));
  const auto found = held.solve(walker.state());
  if (!found) return {};
  return walker.settled({*found, walker.system().next_history(*found), held.iterations()});
}

std::vector<Vec3> block_stress(PathState& path) {
  const State& at = path.walker.state();
  return path.cracks->structure.stress(path.walker.system().loading(), at.d.all(), at.load_factor);
}

BlockStress growing_stress(PathState& path) {
  const State& at = path.walker.state();
  const Tangent& leaving = path.walker.leaving();
  return path.cracks->structure.growing(path.walker.system().loading(), {at.d.all(), at.load_factor},
                                        {leaving.d.all(), leaving.load_factor});
}

CrackFront::Surroundings around(PathState& path) {
  const auto stress_at = [&structure = path.cracks->structure, means = block_stress(path),
                          &loading = path.walker.system().loading(),
                          &at = path.walker.state()](const Vec2& x) -> std::optional<Vec3> {
    const auto blocks = structure.front().geometry().blocks_near(x);
    if (blocks.empty()) return {};
    const BlockId block = blocks.front();
    Vec3 out = means[block.value()] + stress_beside_mean(structure.body(), block, x, at.d.all());
    for (const auto& [place, share] : eigenstress_beside_mean(structure.body(), block, x))
      out += share * loading.initial_stress(place, at.load_factor);
    return out;
  };
  const std::vector<Cut> cuts = path.cracks->structure.front().geometry().cuts();
  return {stress_at, [&path, cuts](std::span<const Cut> free) { return released_energy(path, cuts, free); }};
}

std::set<int> spent_on(const PathState& path, const std::vector<History>& history) {
  constexpr double round_off = 1e-9;  // of a point that stands at its strength
  const System& system = path.walker.system();
  const std::vector<Cut>& cuts = path.cracks->structure.front().geometry().cuts();
  std::set<int> out;
  for (std::size_t p = 0; p < history.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (!point.is_awaited) continue;
    if (system.kappa(p, history[p]) > (1 + round_off) * point.law->initial_kappa(point.stiffness))
      out.insert(cuts[*point.cut].crack);
  }
  return out;
}

void follow_cuts(PathState& path, const std::vector<Cut>& before) {
  const RunningCracks& cracks = *path.cracks;
  const Growth growth = path.walker.follow([&] { return cracks.structure.remake(before); });
  path.look_up(cracks.look_up());
  path.memory.before.reset();
  if (cracks.has_grown) cracks.has_grown(growth);
}

}  // namespace dda
