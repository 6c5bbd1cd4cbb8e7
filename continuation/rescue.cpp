#include "continuation/rescue.hpp"

#include <cmath>
#include <limits>

#include "continuation/reach.hpp"

namespace dda {
namespace {

/// Secant equilibria of one damage field after another.
class SecantWalk {
 public:
  SecantWalk(System& system, const State& start) : system_(system), state_(start) {}

  /// Grows the critical point and finds the next secant equilibrium.
  bool step() {
    std::vector<History> history = system_.history();
    const auto p = static_cast<std::size_t>(critical_);
    const InterfacePoint& point = system_.equilibrium().point(p);
    constexpr double growth = 1.08;
    history[p].kappa =
        std::min(growth * system_.kappa(p, history[p]), point.law->rupture_kappa(point.stiffness));
    system_.set_history(std::move(history));
    return settle();
  }

  /// The unbroken point nearest its surface at the start.
  bool find_critical() {
    const auto laws = system_.laws_at(state_.d, state_.load_factor);
    double nearest = -1;
    for (std::size_t p = 0; p < laws->opening.size(); ++p) {
      if (is_broken(p)) continue;
      const double ratio = system_.equilibrium().point(p).law->equivalent_opening(laws->opening[p]) /
                           system_.kappa(p, system_.history()[p]);
      if (ratio <= nearest) continue;
      nearest = ratio;
      critical_ = static_cast<int>(p);
    }
    return critical_ >= 0;
  }

  const State& state() const { return state_; }
  std::size_t critical() const { return static_cast<std::size_t>(critical_); }

 private:
  bool is_broken(std::size_t p) const {
    const InterfacePoint& point = system_.equilibrium().point(p);
    return system_.kappa(p, system_.history()[p]) >= point.law->rupture_kappa(point.stiffness);
  }

  /// The secant stiffness depends on which cracks are closed: repeat until that set stays.
  bool settle() {
    constexpr int passes = 12;
    for (int pass = 0; pass < passes; ++pass) {
      const auto secant = system_.laws_at(state_.d, state_.load_factor);
      if (!system_.use_tangent(system_.new_stamp(), secant->tangent)) return false;
      if (!move_to_limit(*secant)) return false;
      if (system_.laws_at(state_.d, state_.load_factor)->tangent == secant->tangent) return true;
    }
    return false;
  }

  /// Scales the load to where the first unbroken point reaches its κ.
  bool move_to_limit(const LawValues& secant) {
    const std::size_t n = state_.d.size(), points = secant.opening.size();
    const auto dead = dead_solution(secant), live = live_solution(secant);
    std::vector<Vec2> q_dead(points), q_live(points);
    const Equilibrium& equilibrium = system_.equilibrium();
    equilibrium.gather(system_.loading(), dead, 0, {q_dead.data()->data(), 2 * points});
    equilibrium.gather(live, {q_live.data()->data(), 2 * points});
    add_offset(system_.loading().reference_offset, q_live);
    double limit = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < points; ++p) {
      if (is_broken(p)) continue;
      const double x =
          reach(*equilibrium.point(p).law, q_dead[p], q_live[p], system_.kappa(p, system_.history()[p]));
      if (x >= limit) continue;
      limit = x;
      critical_ = static_cast<int>(p);
    }
    if (!std::isfinite(limit)) return false;
    for (std::size_t i = 0; i < n; ++i) state_.d[i] = dead[i] + limit * live[i];
    state_.load_factor = limit;
    return true;
  }

  static void add_offset(const std::vector<double>& offset, std::vector<Vec2>& q) {
    for (std::size_t i = 0; i < offset.size(); ++i) q[i / 2][static_cast<Eigen::Index>(i % 2)] += offset[i];
  }

  std::vector<double> solve(std::vector<double> force) {
    std::vector<double> out(force.size());
    system_.linear().solve(force, out);
    return out;
  }

  std::vector<double> live_solution(const LawValues& secant) {
    std::vector<double> minus(state_.d.size());
    system_.load_derivative(secant, minus);
    std::vector<double> out = solve(std::move(minus));
    for (double& value : out) value = -value;
    return out;
  }

  std::vector<double> dead_solution(const LawValues& secant) {
    std::vector<double> force = system_.loading().dead;
    const auto& offset = system_.loading().dead_offset;
    if (!offset.empty()) {
      std::vector<Vec2> t(secant.tangent.size());
      for (std::size_t p = 0; p < t.size(); ++p)
        t[p] = -secant.tangent[p] * Eigen::Map<const Vec2>(offset.data() + 2 * p);
      system_.equilibrium().scatter_add({t.data()->data(), 2 * t.size()}, force);
    }
    for (const double value : force)
      if (value != 0) return solve(std::move(force));
    return force;
  }

  System& system_;
  State state_;
  int critical_ = -1;
};

}  // namespace

std::optional<SecantState> sequentially_linear(System& system, const State& start, double quantum) {
  const std::vector<History> before = system.history();
  const double goal = system.dissipated(before) + quantum;
  system.set_frozen(true);
  SecantWalk walk(system, start);
  bool good = walk.find_critical();
  constexpr int most = 2000;
  for (int i = 0; good && i < most; ++i) {
    good = walk.step();
    if (good && system.dissipated(system.history()) >= goal) break;
  }
  system.set_frozen(false);
  std::optional<SecantState> out;
  if (good) {
    out = SecantState{walk.state(), system.history()};
    for (History& h : out->history) h.loading = false;
    out->history[walk.critical()].loading = true;
  }
  system.set_history(before);
  return out;
}

}  // namespace dda
