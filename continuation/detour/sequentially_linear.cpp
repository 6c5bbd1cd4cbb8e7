#include "continuation/detour/sequentially_linear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/state/history_guard.hpp"
#include "continuation/state/reach.hpp"

namespace dda {
namespace {

/// Secant equilibria of one damage field after another.
class SecantWalk {
 public:
  SecantWalk(System& system, const State& start) : system_(system), state_(start) {}

  /// Grows the critical point and finds the next secant equilibrium. Where the load that brings one point to
  /// its strength leaves another beyond its own, that one is critical next: the state is none to stop at.
  bool step() {
    std::vector<History> history = system_.history();
    const auto p = static_cast<std::size_t>(critical_);
    const InterfacePoint& point = system_.equilibrium().point(p);
    constexpr double growth = 1.08;
    history[p] = point.law->grown(history[p], point.stiffness, growth);
    system_.set_history(std::move(history));
    if (!settle() || !polish()) return false;
    const auto beyond = farthest_beyond();
    is_admissible_ = !beyond;
    if (beyond) critical_ = *beyond;
    if (is_admissible_) system_.set_history(system_.next_history(state_));  // what has slid stays so
    return true;
  }
  bool is_admissible() const { return is_admissible_; }

  /// The unbroken point nearest its surface at the start.
  bool find_critical() {
    const auto laws = system_.laws_at(state_);
    double nearest = -1;
    for (std::size_t p = 0; p < laws->opening.size(); ++p) {
      if (system_.is_broken(p)) continue;
      const double ratio = point_at(p).opening(laws->opening[p]) / system_.kappa(p);
      if (ratio <= nearest) continue;
      nearest = ratio;
      critical_ = static_cast<int>(p);
    }
    return critical_ >= 0;
  }

  const State& state() const { return state_; }
  std::size_t critical() const { return static_cast<std::size_t>(critical_); }

 private:
  LawAt point_at(std::size_t p) const {
    const InterfacePoint& point = system_.equilibrium().point(p);
    return {*point.law, system_.history()[p], point.stiffness};
  }

  /// The unbroken point that stands farthest beyond its surface, if any does.
  std::optional<int> farthest_beyond() const {
    constexpr double round_off = 1e-8;
    const auto laws = system_.laws_at(state_);
    double most = 1 + round_off;
    std::optional<int> out;
    for (std::size_t p = 0; p < laws->opening.size(); ++p) {
      if (system_.is_broken(p)) continue;
      const double ratio = point_at(p).opening(laws->opening[p]) / system_.kappa(p);
      if (!(ratio > most)) continue;
      most = ratio;
      out = static_cast<int>(p);
    }
    return out;
  }

  /// The secant stiffness depends on which cracks are closed and which slide: repeat until these sets stay.
  bool settle() {
    constexpr int passes = 12;
    for (int pass = 0; pass < passes; ++pass) {
      const auto secant = system_.laws_at(state_);
      if (!system_.use_path_tangent(*secant)) return false;
      if (!move_to_limit(*secant)) return false;
      system_.set_multipliers(state_.multipliers);
      if (system_.laws_at(state_)->tangent == secant->tangent) return true;
    }
    return false;
  }

  /// With iterated multipliers: takes off what the rounding of their joints' high stiffness p̄ has left of the
  /// equilibrium; one step, the laws being linear.
  bool polish() {
    if (!system_.iterates_multipliers()) return true;
    const auto laws = system_.laws_at(state_);
    if (!system_.use_tangent(system_.new_stamp(), laws->tangent)) return false;
    std::vector<double> residual(state_.d.size()), correction(state_.d.size());
    system_.residual(state_.d, state_.load_factor, *laws, residual);
    system_.linear().solve(residual, correction);
    state_.d = state_.d.moved(-1, correction);
    return true;
  }

  /// Scales the load to where the first unbroken point reaches its κ.
  bool move_to_limit(const LawValues& secant) {
    const Solution dead = dead_solution(secant), live = live_solution(secant);
    const Loading& loading = system_.loading();
    double limit = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < secant.opening.size(); ++p) {
      if (system_.is_broken(p)) continue;
      const double x = reach(point_at(p), opening(p, dead) + loading.dead_opening(p),
                             opening(p, live) + loading.reference_opening(p));
      if (x >= limit) continue;
      limit = x;
      critical_ = static_cast<int>(p);
    }
    if (!std::isfinite(limit)) return false;
    state_.d = Displacements(dead.d).moved(limit, live.d);
    state_.load_factor = limit;
    for (std::size_t p = 0; p < state_.multipliers.size(); ++p)
      state_.multipliers[p] = multiplier(p, dead) + limit * multiplier(p, live);
    return true;
  }

  /// K_sec⁻¹ f, and what joints with iterated multipliers open beside it.
  struct Solution {
    std::vector<double> d;
    std::vector<Vec2> carried;
  };

  Vec2 opening(std::size_t p, const Solution& of) const {
    const Vec2 g = system_.equilibrium().opening(p, of.d);
    return system_.with_multiplier(p, of.carried.empty() ? g : g + of.carried[p]);
  }
  Vec2 multiplier(std::size_t p, const Solution& of) const {
    return opening(p, of) - system_.equilibrium().opening(p, of.d);
  }

  /// Carries what the finite p̄ leaves open over into the joints until that no longer changes.
  Solution closed(const std::vector<double>& force) {
    Solution out{solve(force), {}};
    if (!system_.iterates_multipliers()) return out;
    constexpr int most = 5;
    constexpr double round_off = 1e-14;
    out.carried.assign(system_.multipliers().size(), Vec2::Zero());
    for (int pass = 0; pass < most; ++pass) {
      std::vector<Vec2> left = system_.left_open(out.d, out.carried);
      double change = 0, largest = 0;
      for (std::size_t p = 0; p < left.size(); ++p) {
        change = std::max(change, (left[p] - out.carried[p]).norm());
        largest = std::max(largest, left[p].norm());
      }
      if (change <= round_off * largest) break;
      out.carried = std::move(left);
      std::vector<double> rest = force;
      system_.subtract_carried(out.carried, rest);
      out.d = solve(std::move(rest));
    }
    return out;
  }

  /// Refined as long as it gains: an update of a base that holds some blocks loosely leaves much to take off.
  std::vector<double> solve(std::vector<double> rest) {
    LinearSystem& linear = system_.path_linear();
    const std::vector<double> force = rest;
    std::vector<double> out(force.size(), 0.0), correction(force.size());
    constexpr double gain = 0.5;
    for (double before = std::numeric_limits<double>::infinity();;) {
      const double left = system_.residual_norm(rest);
      if (!(left > 0 && left <= gain * before)) return out;
      before = left;
      linear.solve(rest, correction);
      for (std::size_t i = 0; i < out.size(); ++i) out[i] += correction[i];
      linear.multiply(out, rest);
      for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = force[i] - rest[i];
    }
  }

  Solution live_solution(const LawValues& secant) {
    std::vector<double> force(state_.d.size());
    system_.load_derivative(secant, force);
    for (double& value : force) value = -value;
    return closed(force);
  }

  /// At no load factor: dead loads, and what friction bears beside D q on points that have slid.
  Solution dead_solution(const LawValues& secant) {
    std::vector<double> force = system_.loading().dead;
    const Loading& loading = system_.loading();
    constexpr double rounding = 1e-12;
    std::vector<Vec2> t(secant.tangent.size(), Vec2::Zero());
    bool is_needed = !loading.dead_offset.empty();
    for (std::size_t p = 0; p < t.size(); ++p) {
      const Vec2 held = secant.traction[p] - secant.tangent[p] * secant.opening[p];
      const bool is_held = held.norm() > rounding * secant.traction[p].norm();
      if (is_held) t[p] = -held;
      t[p] -= secant.tangent[p] * loading.dead_opening(p);
      is_needed = is_needed || is_held;
    }
    if (is_needed) system_.equilibrium().scatter_add(components(t), force);
    for (const double value : force)
      if (value != 0) return closed(force);
    return {std::move(force), {}};
  }

  System& system_;
  State state_;
  int critical_ = -1;
  bool is_admissible_ = false;
};

}  // namespace

std::optional<Settled> sequentially_linear(System& system, const State& start, double quantum) {
  const HistoryGuard back(system, start.multipliers);
  const double goal = system.dissipated(system.history()) + quantum;
  system.set_frozen(true);
  SecantWalk walk(system, start);
  std::optional<Settled> out;
  constexpr int most = 2000;
  bool is_enough = !walk.find_critical();
  for (int i = 0; i < most && !is_enough && walk.step(); ++i) {
    if (!walk.is_admissible()) continue;
    out = Settled{walk.state(), system.history(), i + 1};
    for (History& h : out->history) h.loading = false;
    out->history[walk.critical()].loading = true;
    is_enough = system.dissipated(system.history()) >= goal;
  }
  return out;
}

}  // namespace dda
