#include "continuation/solve/reduced.hpp"

#include "continuation/contact/cracked_points.hpp"

namespace dda {
namespace {

/// Points of some kind that are not held at a state as in the intact structure.
template <class Kind>
std::size_t count_changed(System& system, const State& at, Kind is_of_kind) {
  const auto laws = system.laws_at(at.d, at.load_factor);
  std::size_t out = 0;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    const Vec2 intact = point.intact_stiffness().cwiseProduct(laws->opening[p]);
    constexpr double round_off = 1e-14;
    out += (laws->traction[p] - intact).norm() > round_off * intact.norm() && is_of_kind(point);
  }
  return out;
}

}  // namespace

bool has_offsets(const System& system) {
  return !system.loading().dead_offset.empty() || !system.loading().reference_offset.empty();
}

std::vector<std::size_t> newly_cracked(System& system, const LinearSystem& linear, const State& at) {
  const auto laws = system.laws_at(at.d, at.load_factor);
  std::vector<std::size_t> out;
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    if (linear.has_columns(p)) continue;
    const Vec2 jump =
        system.iterates_multipliers() ? Vec2(laws->opening[p] - system.multipliers()[p]) : laws->opening[p];
    if (!linear.is_as_in_base(p, jump, {laws->traction[p], laws->tangent[p]})) out.push_back(p);
  }
  return out;
}

std::optional<Reduced> solve_reduced(System& system, const StepGoal& goal, int max_iterations) {
  const auto sum = goal.control.as_sum(goal.step);
  if (!sum || system.frozen() || !system.linear().updates() || system.iterates_multipliers()) return {};
  if (has_offsets(system)) return {};
  Reduced out;
  constexpr int most_rounds = 8;
  for (int round = 0; round < most_rounds; ++round) {
    CrackedPoints points(system, system.linear(), *sum);
    const auto iterations = [&] {
      const auto scope = system.timings().measure("reduced iterations");
      points.start_at(goal.guess);
      return points.newton(max_iterations, CrackedPoints::Cycles::may_settle);
    }();
    if (!iterations) return {};
    out.iterations += *iterations;
    out.state = points.state();
    const std::vector<std::size_t> added = newly_cracked(system, system.linear(), out.state);
    if (added.empty()) return out;
    if (!system.linear().make_columns(added)) return {};
  }
  return {};
}

std::size_t num_changed(System& system, const State& at) {
  return count_changed(system, at, [](const InterfacePoint&) { return true; });
}

std::size_t num_cracked(System& system, const State& at) {
  return count_changed(system, at, [](const InterfacePoint& point) { return !point.is_separate(); });
}

}  // namespace dda
