#include "continuation/tangent.hpp"

namespace dda {
namespace {

/// K⁻¹ ∂f/∂λ with the history's flags, per unit of load factor; empty when K is singular.
Tangent direction(System& system, const State& state) {
  Tangent out;
  const auto laws = system.laws_at(state.d, state.load_factor);
  std::vector<double> force(state.d.size());
  system.load_derivative(*laws, force);
  if (!system.use_path_tangent(*laws)) return out;
  out.d.resize(state.d.size());
  system.path_linear().solve_watched(force, out.d);
  for (double& value : out.d) value = -value;
  out.load_factor = 1;
  out.multipliers = system.multiplier_rates(out.d);
  out.opening.resize(laws->opening.size());
  for (std::size_t p = 0; p < out.opening.size(); ++p)
    out.opening[p] = system.opening_rate(p, out.d) + system.loading().reference_opening(p);
  return out;
}

/// Energy spent per unit of load factor where cracks grow, friction included; 0 when none grows.
double dissipation_rate(System& system, const State& state, const Tangent& along) {
  double sum = 0;
  bool grows = false;
  const auto laws = system.laws_at(state.d, state.load_factor);
  for (std::size_t p = 0; p < along.opening.size(); ++p) {
    const History& h = system.history()[p];
    if (!h.loading && !h.sliding) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const double rate =
        point.weight *
        point.law->spending(laws->opening[p], h, point.stiffness).gradient.dot(along.opening[p]);
    grows = grows || (h.loading && rate != 0);
    sum += rate;
  }
  return grows ? sum : 0;
}

void scale(double factor, std::vector<Vec2>& v) {
  for (Vec2& value : v) value *= factor;
}

/// The same direction in its unit: per energy that it dissipates, per load factor where it dissipates none.
Tangent in_unit(System& system, const State& state, Tangent out) {
  if (out.d.empty()) return out;
  const double rate = dissipation_rate(system, state, out);
  out.dissipates = rate != 0;
  if (!out.dissipates) return out;
  for (double& value : out.d) value /= rate;
  scale(1 / rate, out.opening);
  scale(1 / rate, out.multipliers);
  out.load_factor = 1 / rate;
  return out;
}

Tangent oriented(System& system, const State& state) {
  const auto scope = system.timings().measure("tangents");
  return in_unit(system, state, direction(system, state));
}

/// Unflags what unloads or sticks; false when there was nothing to unflag.
bool prune(System& system, const State& state, const Tangent& found) {
  std::vector<History> history = system.history();
  bool changed = false;
  const auto laws = system.laws_at(state.d, state.load_factor);
  for (std::size_t p = 0; p < found.opening.size(); ++p) {
    History& h = history[p];
    if (!h.loading && !h.sliding) continue;
    const InterfacePoint& point = system.equilibrium().point(p);
    const auto turns_back = [&](const Vec2& gradient) { return gradient.dot(found.opening[p]) < 0; };
    if (h.loading && !point.law->releases_at_once() &&
        turns_back(point.law->opening_gradient(laws->opening[p], h, point.stiffness)))
      h.loading = !(changed = true);
    if (h.sliding && turns_back(point.law->slip_gradient(laws->opening[p], h, point.stiffness)))
      h.sliding = !(changed = true);
  }
  if (changed) system.set_history(std::move(history));
  return changed;
}

}  // namespace

Tangent arriving_tangent(System& system, const State& state) { return oriented(system, state); }

Tangent leaving_tangent(System& system, const State& state, Tangent arriving) {
  while (!arriving.d.empty() && prune(system, state, arriving)) arriving = oriented(system, state);
  return arriving;
}

Tangent starting_tangent(System& system, const State& state) {
  const auto scope = system.timings().measure("tangents");
  Tangent out = direction(system, state);
  while (!out.d.empty() && prune(system, state, out)) out = direction(system, state);
  return in_unit(system, state, std::move(out));
}

}  // namespace dda
