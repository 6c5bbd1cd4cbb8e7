#include "continuation/detour/release.hpp"

#include <algorithm>
#include <cmath>

#include "continuation/detour/increment/load_increment.hpp"
#include "continuation/solve/held_equilibrium.hpp"
#include "continuation/state/history_guard.hpp"
#include "continuation/state/reach.hpp"

namespace dda {
namespace {

bool stands_at_strength(const System& system, std::size_t p) {
  return system.history()[p].loading && system.equilibrium().point(p).law->releases_at_once();
}

bool is_pending(const System& system, std::size_t p) {
  return system.history()[p].share > 0 || stands_at_strength(system, p);
}

/// One release, from the start of a piece to its end.
class Release {
 public:
  Release(Stepper& stepper, const State& start)
      : stepper_(stepper),
        system_(stepper.system()),
        start_(start),
        before_(system_.history()),
        openings_(system_.laws_at(start)->opening) {
    for (std::size_t p = 0; p < before_.size(); ++p)
      if (is_pending(system_, p)) pending_.push_back(p);
  }

  std::optional<ReleasedPiece> next(const Functional* held, double most) {
    const HistoryGuard back(system_, start_.multipliers);
    const Functional own = held ? Functional{} : held_opening();
    const Functional& gauge = held ? *held : own;
    HeldEquilibrium equilibrium(stepper_, gauge, start_.value(gauge));
    auto out = at_share(equilibrium, most, start_);
    double gone = most;
    if (out) gone = up_to_crossing(equilibrium, most, out);
    if (!out) return {};
    const bool turns = out->state.load_factor * start_.load_factor < 0;
    return ReleasedPiece{*out, !turns || is_straight(equilibrium, gone, *out)};
  }

 private:
  /// How much has gone where the first point reaches its strength, and the equilibrium there instead of that where `most`
  /// has gone. The way is straight as long as no contact changes on it; where one does, the crossing is bracketed.
  double up_to_crossing(HeldEquilibrium& equilibrium, double most, std::optional<Settled>& out) {
    constexpr int most_searches = 40;
    constexpr double round_off = 1e-12;
    double before = 0, gone = most, beyond = most;
    std::vector<Vec2> from = openings_, to = opening(*out);
    for (int search = 0; search < most_searches; ++search) {
      double share = first_crossing(from, opening(*out));
      if (share < 1 - round_off) {
        beyond = gone;
        to = opening(*out);
      } else {
        if (gone >= beyond || stands_at_crossing(opening(*out), to)) break;
        before = gone;
        from = opening(*out);
        share = first_crossing(from, to);
      }
      gone = before + share * (beyond - before);
      out = at_share(equilibrium, gone, out->state);
      if (!out) break;
    }
    return gone;
  }

  /// Whether a point has come to its strength, on the way to where it is beyond.
  bool stands_at_crossing(const std::vector<Vec2>& at, const std::vector<Vec2>& beyond) const {
    constexpr double round_off = 1e-10;
    for (std::size_t p = 0; p < before_.size(); ++p) {
      const InterfacePoint& point = system_.equilibrium().point(p);
      const LawAt law{*point.law, system_.history()[p], point.stiffness};
      if (law.law.is_broken(law.history, law.stiffness)) continue;
      if (law.opening(at[p]) >= law.kappa() * (1 - round_off) &&
          law.opening(beyond[p]) > law.kappa() * (1 + round_off))
        return true;
    }
    return false;
  }

  std::vector<Vec2> opening(const Settled& at) { return system_.laws_at(at.state)->opening; }

  /// Whether half of the loss lies half way in the load factor: no contact and no friction has changed.
  bool is_straight(HeldEquilibrium& equilibrium, double gone, const Settled& end) {
    const auto middle = at_share(equilibrium, 0.5 * gone, start_);
    if (!middle) return false;
    constexpr double round_off = 1e-6;
    const double a = start_.load_factor, b = end.state.load_factor;
    return std::abs(middle->state.load_factor - 0.5 * (a + b)) <= round_off * (std::abs(a) + std::abs(b));
  }

  /// c·q of the point that reached its strength last: it has lost least.
  Functional held_opening() const {
    const std::size_t newest = std::ranges::max(pending_, {}, [&](std::size_t p) { return share(p); });
    const InterfacePoint& point = system_.equilibrium().point(newest);
    const History released = point.law->release(openings_[newest], before_[newest], point.stiffness, 1);
    const Vec2 direction = point.law->held_direction(openings_[newest], released);
    return system_.equilibrium().opening_gauge(system_.loading(), newest, direction);
  }

  /// What a pending point still bears of what it loses.
  double share(std::size_t p) const {
    return before_[p].share > 0 && !before_[p].loading ? before_[p].share : 1;
  }

  /// The equilibrium when `gone` of what is being lost at the start of the piece has gone.
  std::optional<Settled> at_share(HeldEquilibrium& equilibrium, double gone, const State& guess) {
    std::vector<History> releasing = before_;
    for (const std::size_t p : pending_) {
      const InterfacePoint& point = system_.equilibrium().point(p);
      releasing[p] = point.law->release(openings_[p], before_[p], point.stiffness, (1 - gone) * share(p));
    }
    system_.set_history(std::move(releasing));
    system_.set_multipliers(guess.multipliers);
    const auto found = equilibrium.solve(guess);
    if (!found) return {};
    return Settled{*found, system_.next_history(*found), equilibrium.iterations()};
  }

  /// Share of the straight way at which another point reaches its strength first, or one that is losing its cohesion that in
  /// tension; 1 when none does.
  double first_crossing(const std::vector<Vec2>& from, const std::vector<Vec2>& to) const {
    constexpr double round_off = 1e-12;
    double first = 1;
    for (std::size_t p = 0; p < before_.size(); ++p) {
      const InterfacePoint& point = system_.equilibrium().point(p);
      first = std::min(first, share_to_kappa({*point.law, system_.history()[p], point.stiffness}, from[p],
                                             to[p], round_off));
    }
    return first;
  }

  Stepper& stepper_;
  System& system_;
  const State& start_;
  const std::vector<History> before_;
  const std::vector<Vec2> openings_;
  std::vector<std::size_t> pending_;
};

}  // namespace

bool is_release_pending(const System& system) {
  for (std::size_t p = 0; p < system.history().size(); ++p)
    if (is_pending(system, p)) return true;
  return false;
}

std::optional<ReleasedPiece> release_piece(Stepper& stepper, const State& start, const ReleaseAim& aim) {
  return Release(stepper, start).next(aim.held, aim.most);
}

namespace {

/// Releases in full what stands at its strength or is partly released.
void release_pending(System& system, const State& at) {
  std::vector<History> history = system.history();
  const auto laws = system.laws_at(at);
  for (std::size_t p = 0; p < history.size(); ++p) {
    const InterfacePoint& point = system.equilibrium().point(p);
    if (is_pending(system, p))
      history[p] = point.law->release(laws->opening[p], history[p], point.stiffness, 0);
  }
  system.set_history(std::move(history));
}

/// Newton's method with a gauge held, whatever the load.
class AtGauge final : public LoadSolver {
 public:
  AtGauge(const Functional& gauge, double value) : gauge_(gauge), value_(value) {}

  Found solve(Stepper& stepper, const State& from, double) override {
    HeldEquilibrium equilibrium(stepper, gauge_, value_);
    Found out;
    out.state = equilibrium.solve(from);
    out.newton_iterations = equilibrium.iterations();
    return out;
  }

 private:
  const Functional& gauge_;
  double value_;
};

}  // namespace

std::optional<Settled> release_at_load(Stepper& stepper, const State& start, double load_factor) {
  const Functional load{.rows = {}, .per_load_factor = 1};
  return release_at_gauge(stepper, start, {load, load_factor});
}

std::optional<Settled> release_at_gauge(Stepper& stepper, const State& start, const WantedGauge& wanted) {
  const HistoryGuard back(stepper.system(), start.multipliers);
  release_pending(stepper.system(), start);
  AtGauge solver(wanted.gauge, wanted.value);
  return load_increment(stepper, start, {0, solver}).settled;
}

}  // namespace dda
