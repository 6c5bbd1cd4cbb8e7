#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/follow/pace.hpp"
#include "continuation/follow/trial.hpp"
#include "continuation/step/cuts.hpp"
#include "continuation/step/rung/rungs.hpp"
#include "continuation/step/steps.hpp"

namespace dda {
namespace {

constexpr double at_its_strength = 1 - 1e-6;

/// Whether some point stands beyond its strength.
bool is_exceeded(const System& system, const State& at) {
  constexpr double round_off = 1e-9;
  const auto laws = system.laws(at);
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (!system.is_broken(p) &&
        point.law->equivalent_opening(laws.opening[p], system.history()[p], point.stiffness) >
            (1 + round_off) * system.kappa(p))
      return true;
  }
  return false;
}

/// The equilibrium with these cuts under the same load where nothing has cracked yet.
std::optional<Attempt> under_same_load(Walker& walker) {
  if (walker.here().dissipated > 0) return {};
  const auto equation = make_gauge_equation({.rows = {}, .per_load_factor = 1});
  Attempt tried = walker.attempt(*equation, 0, walker.state(), Thoroughness::full);
  if (!tried.converged || is_exceeded(walker.system(), tried.state)) return {};
  return tried;
}

/// The equilibrium with these cuts, damage as it is, whose first point stands at its strength; as long as nothing has
/// cracked that under the same load, if no point is beyond its strength there. Nothing where the load would change by
/// more than this share of its largest.
std::optional<Candidate> settled(PathState& path, double far) {
  Walker& walker = path.walker;
  auto tried = under_same_load(walker);
  if (!tried)
    tried = walker.attempt(*make_event_equation(walker.system()), 1, walker.state(), Thoroughness::full);
  if (!tried->converged) {
    path.refusal = tried->reason;
    return {};
  }
  Candidate out =
      walker.settled({tried->state, walker.system().next_history(tried->state), tried->newton_iterations});
  out.solution = tried->solution;
  const double moved = std::abs(path.load_of(out.state) - path.load_of(walker.state()));
  if (moved <= far * path.memory.peak_load && path.load_of(out.state) >= 0) return out;
  path.refusal = fmt::format("the load would jump by {:.2g} of its peak", moved / path.memory.peak_load);
  return {};
}

/// Cuts at the beginning that have stayed.
std::ptrdiff_t num_same(const std::vector<Cut>& before, const std::vector<Cut>& cuts) {
  return std::ranges::mismatch(before, cuts, [](const Cut& a, const Cut& b) { return a.is_at(b); }).in2 -
         cuts.begin();
}

/// ½ Σ W t·P⁻¹t of the closed segment ahead of a crack: what its cuts store, which without them the rest gives back.
/// `cuts` are those that the equilibrium has.
double energy_ahead(const PathState& path, int crack, const std::vector<Cut>& cuts) {
  const System& system = path.walker.system();
  const auto laws = system.laws(path.walker.state());
  double out = 0;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (point.is_awaited && cuts[*point.cut].crack == crack)
      out += point.weight / 2 * laws.traction[p].dot(laws.traction[p].cwiseQuotient(point.trial_stiffness()));
  }
  return out;
}

/// The same of the bonds that new cuts along sides replace: a joint whose law makes it stiffer in shear takes it back.
double energy_of_opened_bonds(const PathState& path, const std::vector<Cut>& before) {
  const Equilibrium& equilibrium = path.walker.system().equilibrium();
  const std::vector<Cut>& cuts = path.cracks->structure.front().geometry().cuts();
  const auto first_new = cuts.begin() + num_same(before, cuts);
  const std::vector<double>& d = path.walker.state().d.all();
  double out = 0;
  for (std::size_t p = equilibrium.num_active(); p < equilibrium.num_points(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    if (std::none_of(first_new, cuts.end(), [&](const Cut& cut) { return cut.side == point.side; })) continue;
    const Vec2 q = equilibrium.opening(p, d);
    out += point.weight / 2 * q.dot(point.trial_stiffness().cwiseProduct(q));
  }
  return out;
}

/// ½ Σ W (t·P⁻¹t − τ·P⁻¹τ) of new cuts, τ the part of their traction t that strains bring: what a cut stores of initial
/// stress, which a load of strains gives to it as it grows, and has not given to one that has not been there.
double energy_of_initial_stress(const PathState& path, const std::vector<Cut>& before) {
  const System& system = path.walker.system();
  const std::vector<Cut>& cuts = path.cracks->structure.front().geometry().cuts();
  const std::vector<double>& d = path.walker.state().d.all();
  const auto laws = system.laws(path.walker.state());
  double out = 0;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (!point.cut || static_cast<std::ptrdiff_t>(*point.cut) < num_same(before, cuts)) continue;
    Vec2 of_strains = Vec2::Zero();
    point.for_each_stress([&](BlockId node, const Mat26& rows) {
      of_strains += rows * Eigen::Map<const Vec6>(d.data() + block_unknowns * node.value());
    });
    const auto energy = [&](const Vec2& t) { return t.dot(t.cwiseQuotient(point.trial_stiffness())); };
    out += point.weight / 2 * (energy(laws.traction[p]) - energy(of_strains));
  }
  return std::max(out, 0.0);
}

std::string place(const Vec2& x) { return fmt::format("({:.6g}, {:.6g})", x.x(), x.y()); }

}  // namespace

std::optional<int> crack_to_grow(PathState& path) {
  if (!path.cracks) return {};
  System& system = path.walker.system();
  const auto laws = system.laws_at(path.walker.state());
  std::optional<int> out;
  double most = at_its_strength;
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

namespace {

constexpr double near = 0.02, anywhere = 1;  // of the largest load

/// A point of the path where the structure, having been made anew, is in equilibrium; nothing where there is none near.
std::optional<Point> settle_down(PathState& path, double bearable, double far = near) {
  auto next = settled(path, far);
  if (!next) return {};
  const double step = path.memory.step;
  Tangent onward = path.walker.leaving();
  auto point = jump_to(path, *std::move(next), StepKind::growth, bearable);
  path.memory.step = step;
  if (point && onward.dissipates) path.walker.turn_to(std::move(onward), path.walker.here().history);
  return point;
}

/// Where the load's displacement is held.
std::optional<Point> stand_still(PathState& path, double bearable) {
  auto next = standing_still(path);
  return next ? jump_to(path, *std::move(next), StepKind::growth, bearable) : std::optional<Point>();
}

/// Where no equilibrium is near: the cut is made where the path stands, and a step goes on from there; or, where
/// nothing leads on, as under a dead load that has passed strengths, the load's displacement is held.
std::optional<Point> step_on(PathState& path, double bearable) {
  const std::string why = path.refusal;
  path.reject(to_string(StepKind::growth), why);
  if (!path.walker.leaving().dissipates) return stand_still(path, bearable);
  const Move move = path.control->next(path.walker);
  const bool is_known = path.memory.step > 0 && path.memory.step_kind == move.kind;
  const double first =
      bounded(path, move, is_known ? path.memory.step / unit_of(path, move) : first_amount(path, move));
  for (double share = 1; share > smallest_share; share *= path.parameters.step.cut)
    if (const auto candidate = try_step(path, move, share * first, thoroughness_of(share)))
      return keep(path, *candidate, StepKind::growth);
  path.refusal = why;
  return {};
}

}  // namespace

std::optional<Point> growth_step(PathState& path, int crack) {
  CrackFront& front = path.cracks->structure.front();
  if (path.cracks->grows) path.cracks->grows();
  const std::vector<Cut> cuts = front.geometry().cuts();
  const std::vector<CrackFront::Memory> memory = front.memory();
  front.grow(crack);
  double bearable = energy_of_opened_bonds(path, cuts);  // a closed cut makes nothing stiffer
  follow_cuts(path, cuts);
  bearable += energy_of_initial_stress(path, cuts);
  path.report("grown", front.end_of(crack).empty()
                           ? fmt::format("crack {} has grown to {}", crack, place(front.tip(crack)))
                           : fmt::format("crack {} ends at {}: {}", crack, place(front.tip(crack)),
                                         front.end_of(crack)));
  auto point = settle_down(path, bearable);
  if (!point) point = step_on(path, bearable);
  if (!point) point = settle_down(path, bearable, anywhere);
  if (!point)
    point = stand_still(path, bearable);  // what lies ahead is far beyond its strength, as behind a dry joint
  if (point) return point;
  const std::vector<Cut> refused = front.geometry().cuts();
  front.restore(cuts, memory);
  follow_cuts(path, refused);
  return path.stop_early(
      Stop::crack_grown,
      fmt::format("no equilibrium was found next to the last one once the crack at {} had grown: {}",
                  place(front.tip(crack)), path.refusal));
}

std::optional<Point> aim_step(PathState& path, int crack, const PlaceBefore& before) {
  if (spent_on(path, before.history()).contains(crack)) return {};
  CrackFront& front = path.cracks->structure.front();
  const PlaceBefore reached(path);
  const std::vector<Cut> cuts = front.geometry().cuts();
  const std::vector<CrackFront::Memory> memory = front.memory();
  if (path.cracks->grows) path.cracks->grows();
  if (!front.aim(crack, around(path))) return {};
  before.go_back(path);
  const double bearable = energy_ahead(path, crack, cuts) + energy_of_opened_bonds(path, cuts);
  follow_cuts(path, cuts);
  path.report("aimed", fmt::format("crack {} is aimed anew from {}", crack, place(front.tip(crack))));
  if (before.is_at_rest()) {
    path.walker.begin_stage(path.walker.system().equilibrium().stages().size() - 1);
    return {};
  }
  if (auto point = settle_down(path, bearable)) return point;
  const std::vector<Cut> refused = front.geometry().cuts();
  front.restore(cuts, memory);
  follow_cuts(path, refused);
  reached.go_back(path);
  return {};
}

}  // namespace dda
