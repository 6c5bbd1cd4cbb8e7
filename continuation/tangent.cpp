#include "continuation/tangent.hpp"

#include <cmath>
#include <optional>
#include <set>

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

/// What the live loads do along a direction: forces per unit of their factor, and the size of what all do
/// with them now.
struct LivePower {
  double of_forces = 0, size = 0;
};

LivePower live_power(const System& system, const State& state, const Tangent& along) {
  const Loading& loading = system.loading();
  LivePower out;
  for (std::size_t i = 0; i < loading.reference_work.size(); ++i)
    out.of_forces += loading.reference_work[i] * along.d[i];
  out.size = std::abs(state.load_factor * out.of_forces);
  for (const WorkPair& pair : loading.driven)
    out.size += std::abs(pair.force.value(state.d, state.load_factor) * along.rate(pair.displacement));
  return out;
}

void scale(double factor, std::vector<Vec2>& v) {
  for (Vec2& value : v) value *= factor;
}

void reverse(Tangent& along) {
  along.load_factor *= -1;
  for (double& value : along.d) value *= -1;
  scale(-1, along.opening);
  scale(-1, along.multipliers);
}

/// Towards more energy spent; where none is, as the forces of the live loads push.
Tangent oriented(System& system, const State& state) {
  const auto scope = system.timings().measure("tangents");
  Tangent out = direction(system, state);
  if (out.d.empty()) return out;
  const double rate = dissipation_rate(system, state, out);
  const LivePower power = live_power(system, state, out);
  constexpr double rounding = 1e-10;  // left of cracks that stand still while a mechanism turns
  out.dissipates = std::abs(rate) > rounding * power.size;
  if (!out.dissipates) {
    if (power.of_forces < 0) reverse(out);
    return out;
  }
  for (double& value : out.d) value /= rate;
  scale(1 / rate, out.opening);
  scale(1 / rate, out.multipliers);
  out.load_factor = 1 / rate;
  return out;
}

/// A flag of a point that stands on its damage surface or at its limit of friction.
struct Flag {
  std::size_t point;
  bool History::*side;  ///< loading or sliding
};

/// The rate problem of an equilibrium: which of the points flagged in the history go on loading and sliding.
///
///     flagged:  κ̇ ≥ 0 (slip rate ≥ 0);      not flagged, on the surface:  κ̇ ≤ 0
class RateProblem {
 public:
  using Set = std::vector<bool>;
  enum class Sense { dissipates, loads };  ///< what orients the direction: energy spent, or the load factor
  RateProblem(System& system, const State& state, Sense sense)
      : system_(system), state_(state), sense_(sense) {
    const auto laws = system.laws_at(state.d, state.load_factor);
    for (std::size_t p = 0; p < system.history().size(); ++p) {
      const History& h = system.history()[p];
      const InterfacePoint& point = system.equilibrium().point(p);
      if (h.loading && !point.law->releases_at_once())
        add({p, &History::loading}, point.law->opening_gradient(laws->opening[p], h, point.stiffness));
      if (h.sliding)
        add({p, &History::sliding}, point.law->slip_gradient(laws->opening[p], h, point.stiffness));
    }
  }

  /// Takes off whatever unloads or sticks until the rest goes on; where something that was taken off would go
  /// on after all, flags are exchanged, if that ends.
  Tangent solve(Tangent found) {
    const Set refusing = refused(found);
    while (!found.d.empty() && unflag(found)) found = tangent();
    if (found.d.empty() || !worst(found)) return found;
    const std::vector<History> pruned = system_.history();
    if (auto other = exchanged(found)) return *std::move(other);
    turn(refusing);
    if (auto other = exchanged(tangent())) return *std::move(other);
    system_.set_history(pruned);
    return found;
  }
  Tangent tangent() const {
    Tangent out = oriented(system_, state_);
    if (sense_ == Sense::loads && out.load_factor < 0) reverse(out);
    return out;
  }

 private:
  /// Changes one flag at a time until none contradicts its rate: of those that lead to a set that has not
  /// been, the one that contradicts most. Nothing when all have been, or after changes of twice the flags.
  std::optional<Tangent> exchanged(Tangent found) {
    std::set<Set> seen;
    while (!found.d.empty() && seen.size() <= 2 * flags_.size()) {
      if (!worst(found)) return found;
      seen.insert(flags());
      const auto next = worst(found, seen);
      if (!next) return {};
      flip(*next);
      found = tangent();
    }
    return {};
  }

  void add(const Flag& flag, const Vec2& gradient) {
    flags_.push_back(flag);
    gradients_.push_back(gradient);
  }
  double rate(std::size_t i, const Tangent& along) const {
    return gradients_[i].dot(along.opening[flags_[i].point]);
  }
  bool is_set(std::size_t i) const { return system_.history()[flags_[i].point].*flags_[i].side; }

  bool unflag(const Tangent& found) {
    std::vector<History> history = system_.history();
    bool changed = false;
    for (std::size_t i = 0; i < flags_.size(); ++i)
      if (is_set(i) && rate(i, found) < 0) history[flags_[i].point].*flags_[i].side = !(changed = true);
    if (changed) system_.set_history(std::move(history));
    return changed;
  }

  /// The flag that contradicts its rate most, of those whose change leads to none of the sets `seen`.
  std::optional<std::size_t> worst(const Tangent& along, const std::set<Set>& seen = {}) const {
    constexpr double round_off = 1e-9;
    double fastest = 0;
    for (std::size_t i = 0; i < flags_.size(); ++i) fastest = std::max(fastest, std::abs(rate(i, along)));
    std::optional<std::size_t> out;
    double most = round_off * fastest;
    for (std::size_t i = 0; i < flags_.size(); ++i) {
      const double contradiction = is_set(i) ? -rate(i, along) : rate(i, along);
      if (contradiction <= most || seen.contains(flipped(i))) continue;
      most = contradiction;
      out = i;
    }
    return out;
  }

  /// The flags that do not go on along a direction.
  Set refused(const Tangent& along) const {
    Set out;
    for (std::size_t i = 0; i < flags_.size(); ++i)
      out.push_back(!along.d.empty() && is_set(i) && rate(i, along) < 0);
    return out;
  }
  /// Only what refused goes on: where a path turns, that goes on while all else unloads and sticks.
  void turn(const Set& refusing) {
    for (std::size_t i = 0; i < flags_.size(); ++i)
      if (is_set(i) != refusing[i]) flip(i);
  }
  Set flipped(std::size_t i) const {
    Set out = flags();
    out[i] = !out[i];
    return out;
  }
  Set flags() const {
    Set out;
    for (std::size_t i = 0; i < flags_.size(); ++i) out.push_back(is_set(i));
    return out;
  }
  void flip(std::size_t i) {
    std::vector<History> history = system_.history();
    bool& flag = history[flags_[i].point].*flags_[i].side;
    flag = !flag;
    system_.set_history(std::move(history));
  }

  System& system_;
  const State& state_;
  Sense sense_;
  std::vector<Flag> flags_;
  std::vector<Vec2> gradients_;
};

}  // namespace

Tangent arriving_tangent(System& system, const State& state) { return oriented(system, state); }

Tangent leaving_tangent(System& system, const State& state, Tangent arriving) {
  return RateProblem(system, state, RateProblem::Sense::dissipates).solve(std::move(arriving));
}

Tangent starting_tangent(System& system, const State& state) {
  RateProblem problem(system, state, RateProblem::Sense::loads);
  return problem.solve(problem.tangent());
}

}  // namespace dda
