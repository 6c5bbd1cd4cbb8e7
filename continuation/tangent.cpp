#include "continuation/tangent.hpp"

#include <cmath>

namespace dda {
namespace {

/// K⁻¹ ∂f/∂λ with the history's flags, and the rate of opening of each point.
struct Direction {
  std::vector<double> d;
  std::vector<double> opening_rate;  ///< e · q̇ of flagged points, 0 elsewhere
  double dissipation_rate = 0;
  bool any_flag = false;
  bool regular = false;
};

Direction direction(System& system, const State& state) {
  Direction out;
  const auto laws = system.laws_at(state.d, state.load_factor);
  std::vector<double> force(state.d.size());
  system.load_derivative(*laws, force);
  out.d.resize(state.d.size());
  if (!system.use_tangent(system.new_stamp(), laws->tangent)) return out;
  system.linear().solve(force, out.d);
  for (double& value : out.d) value = -value;
  out.regular = true;

  const Equilibrium& equilibrium = system.equilibrium();
  const auto& offset = system.loading().reference_offset;
  out.opening_rate.assign(laws->opening.size(), 0.0);
  for (std::size_t p = 0; p < laws->opening.size(); ++p) {
    const History& h = system.history()[p];
    if (!h.loading) continue;
    const InterfacePoint& point = equilibrium.point(p);
    Vec2 rate = equilibrium.opening(p, out.d);
    if (!offset.empty()) rate += Eigen::Map<const Vec2>(offset.data() + 2 * p);
    out.opening_rate[p] = point.law->opening_gradient(laws->opening[p]).dot(rate);
    out.dissipation_rate += point.weight * point.law->dissipation_slope(system.kappa(p, h), point.stiffness) *
                            out.opening_rate[p];
    out.any_flag = true;
  }
  return out;
}

Tangent oriented(Direction from) {
  Tangent out;
  if (!from.regular) return out;
  out.dissipates = from.any_flag && from.dissipation_rate != 0;
  const double per_unit = out.dissipates ? 1 / from.dissipation_rate : 1.0;
  out.d = std::move(from.d);
  out.opening_rate = std::move(from.opening_rate);
  for (double& value : out.d) value *= per_unit;
  for (double& value : out.opening_rate) value *= per_unit;
  out.load_factor = per_unit;
  return out;
}

/// Unflags what unloads; false when there was nothing to unflag.
bool prune(System& system, const Tangent& found) {
  std::vector<History> history = system.history();
  bool changed = false;
  for (std::size_t p = 0; p < found.opening_rate.size(); ++p)
    if (history[p].loading && found.opening_rate[p] < 0) {
      history[p].loading = false;
      changed = true;
    }
  if (changed) system.set_history(std::move(history));
  return changed;
}

}  // namespace

Tangent arriving_tangent(System& system, const State& state) { return oriented(direction(system, state)); }

Tangent leaving_tangent(System& system, const State& state, Tangent arriving) {
  while (!arriving.d.empty() && prune(system, arriving)) arriving = oriented(direction(system, state));
  return arriving;
}

}  // namespace dda
