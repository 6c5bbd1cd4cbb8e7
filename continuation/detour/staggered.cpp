#include "continuation/detour/staggered.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "continuation/solve/held_equilibrium.hpp"
#include "continuation/state/history_guard.hpp"
#include "continuation/state/reach.hpp"

namespace dda {
namespace {

class Staggered {
 public:
  Staggered(Stepper& stepper, const State& start, const WantedGauge& wanted)
      : stepper_(stepper),
        system_(stepper.system()),
        equilibrium_(stepper, wanted.gauge, wanted.value),
        state_(start) {}

  std::optional<Settled> settle() {
    constexpr int most = 300;
    constexpr double near = 0.01, nearer = 0.5, round_off = 1e-10;  // growths of κ
    double ask_newton = near, before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most; ++i) {
      if (stepper_.is_broken_off()) throw BrokenOff{};
      if (!hold(true)) return {};
      const std::vector<double> growths = growths_asked_for();
      const double growth = growths.empty() ? 0 : std::ranges::max(growths);
      if (growth <= round_off) return settled();
      if (!grow(growths, stretch(growth, before))) return {};
      if (growth < before && growth <= ask_newton) {
        const State staggered = state_;
        if (hold(false)) return settled();
        state_ = staggered;
        ask_newton = nearer * growth;
      }
      before = growth;
    }
    return {};
  }

 private:
  /// The equilibrium with the history in force, its damage frozen or not.
  bool hold(bool is_frozen) {
    system_.set_frozen(is_frozen);
    auto found = equilibrium_.solve(state_);
    if (found) state_ = *std::move(found);
    return found.has_value();
  }

  Settled settled() const { return {state_, system_.next_history(state_), equilibrium_.iterations()}; }

  /// By how much each κ is passed, as a share of it; 0 where it is not.
  std::vector<double> growths_asked_for() const {
    const auto laws = system_.laws_at(state_);
    std::vector<double> out(laws->opening.size(), 0.0);
    for (std::size_t p = 0; p < out.size(); ++p) {
      if (system_.is_broken(p)) continue;
      const InterfacePoint& point = system_.equilibrium().point(p);
      const LawAt law{*point.law, system_.history()[p], point.stiffness};
      out[p] = std::max(0.0, law.opening(laws->opening[p]) / law.kappa() - 1);
    }
    return out;
  }

  /// How much farther damage may grow than is asked for now: what falls by a share r from one iteration to the next is to
  /// grow by 1/(1 − r) as much until it stands, and what rises goes on. No κ runs ahead by more than one of a sequentially
  /// linear step.
  static double stretch(double growth, double before) {
    constexpr double most = 0.08, some = 0.5;
    const double ratio = growth / before, room = std::max(1.0, most / growth);
    return ratio < 1 ? std::clamp(some / (1 - ratio), 1.0, room) : room;
  }

  /// False where a law has no damage that grows.
  bool grow(const std::vector<double>& growths, double stretch) {
    std::vector<History> history = system_.history();
    for (std::size_t p = 0; p < growths.size(); ++p) {
      if (growths[p] == 0) continue;
      const InterfacePoint& point = system_.equilibrium().point(p);
      const double before = point.law->kappa(history[p], point.stiffness);
      history[p] = point.law->grown(history[p], point.stiffness, 1 + stretch * growths[p]);
      if (!(point.law->kappa(history[p], point.stiffness) > before)) return false;
    }
    system_.set_history(std::move(history));
    return true;
  }

  Stepper& stepper_;
  System& system_;
  HeldEquilibrium equilibrium_;
  State state_;
};

}  // namespace

std::optional<Settled> staggered_at_gauge(Stepper& stepper, const State& start, const WantedGauge& wanted) {
  const HistoryGuard back(stepper.system(), start.multipliers);
  return Staggered(stepper, start, wanted).settle();
}

}  // namespace dda
