#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continuation/control/step_kind.hpp"
#include "continuation/control/stop.hpp"
#include "continuation/state/standstill.hpp"
#include "continuation/state/system.hpp"

namespace dda {

/// A value of a gauge on which a step is to end exactly.
struct Landing {
  std::string name;  ///< of the gauge
  Functional gauge;
  double value = 0;
  bool ends_leg = false;
  bool only_falling = false;  ///< counts only when passed downwards
};

/// Share of a value, or of the way to it, by which a gauge may be off and is taken to stand on it.
inline constexpr double same_value = 1e-7;

/// Turns of a displacement gauge that are deeper than this share of its largest value are seen in the rows of
/// the path, whatever the size of the steps.
inline constexpr double turn_depth = 0.005;

/// A part of the path under the loads of one stage: followed by the control, or unloaded.
struct Leg {
  std::string name;
  bool has_loads = false;      ///< of its own; those of the legs before are held
  bool unloads = false;        ///< leaves the damage surfaces and goes straight to `until`
  std::vector<Landing> until;  ///< the next leg begins at the first of them
};

/// What a path is to pass: wanted gauge values, and its legs one after another.
struct Route {
  std::vector<Landing> landings;
  std::vector<Leg> legs = {Leg{}};
};

/// How far a gauge has come since the leg began.
struct Travel {
  double from = 0;      ///< its value then
  double farthest = 0;  ///< the value farthest from it so far
};

/// An accepted point of the path.
struct Point {
  int step = 0;
  StepKind kind = StepKind::event;
  int newton_iterations = 0;
  double residual = 0;  ///< of equilibrium, relative to the force level
  int multiplier_iterations = 0;
  double gap = 0;                   ///< relative, that iterated multipliers leave
  double jump_energy = 0;           ///< released on the way here where no equilibrium path led [FL]
  std::vector<std::string> landed;  ///< "cmod=0.1", "peak?" …: why fields should be kept here
  bool is_highest = false;          ///< the largest load so far
  /// Negative eigenvalues of the stiffness, every point on its damage surface loading: 0 where the
  /// equilibrium is stable under dead load. Nothing where an unsymmetric stiffness does not tell
  /// (unsymmetric_inertia.hpp).
  std::optional<int> num_negative;
  /// Motions whose second-order work is negative, dᵀ K d < 0; of a symmetric stiffness the same number.
  std::optional<int> num_negative_work;
  /// Those that are left under the control: 0 where it is stable if what the control prescribes is held.
  std::optional<int> num_negative_under_control;
  bool switched = false;  ///< the path leaves it by another branch than it would by itself
};

/// Why and how a path ended.
struct Ending {
  enum class Kind { running, goal_reached, stopped_early, interrupted };
  Kind kind = Kind::running;
  std::string reason;
  std::optional<Stop> stop = {};  ///< of one that has stopped early, where it is known
};

/// What loads have done since the start, and what of it neither storage nor dissipation accounts for; jumps are left out
/// of the latter [FL].
struct Balance {
  double work = 0;
  double largest_work = 0;  ///< the largest |work| so far, with which the imbalance is compared
  double imbalance = 0;     ///< Σ (work − storage − dissipation) of steps
  double unaccounted = 0;   ///< and of their sizes

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("balance.work", self.work);
    visit("balance.largest_work", self.largest_work);
    visit("balance.imbalance", self.imbalance);
    visit("balance.unaccounted", self.unaccounted);
  }
};

/// What the path remembers beside the walker; a restart brings it back.
struct PathMemory {
  double peak_load = 0;               ///< largest load so far, in the direction of the first loading
  int direction = 0;                  ///< sign of the load gauge in the first loading; 0 before it
  double step = 0;                    ///< size of the next step in the control's quantity; 0 = choose
  std::optional<StepKind> step_kind;  ///< which that size belongs to
  double largest_displacement = 0;
  double jump_energy = 0;
  double last_quantum = 0;   ///< energy dissipated by the last good step
  double control = 0;        ///< what the control remembers
  int leg = 0;               ///< which leg is being followed
  int leg_start = 0;         ///< accepted steps before it
  int surplus = 0;           ///< negative eigenvalues with which a branch may be left (Candidate::surplus)
  double leg_peak = 0;       ///< largest load since the leg began
  double largest_force = 0;  ///< Σ |force| of loads and driven springs, largest so far [F]
  Balance balance;
  std::map<std::string, Travel> travels;  ///< of all gauges, and of the load as `load`
  int idle_looks = 0;                     ///< looks for a hidden peak, one after another, that found none
  int idle_turn_looks = 0;                ///< and for hidden turns of gauges
  bool has_slid = false;                  ///< a contact has changed since the start
  bool moves_beside_load =
      false;                   ///< the last step has moved joints while the load and its displacement stayed
  double cracked_to_peak = 0;  ///< energy of growing cracks until the load was highest [FL]
  double cracked_since_peak = 0;  ///< and since then
  bool is_mechanism = false;      ///< the load has stayed while the structure moved
  double mechanism_way = 0;       ///< displacement of the load when it began or last brought a goal nearer
  double mechanism_load = 0;      ///< and the load
  double beside_way = 0;          ///< how far joints have moved since it began while that displacement stayed
  double mechanism_share = 0;     ///< and how near the goal was
  double standing_way = 0;  ///< displacement of the load since when it has hardly changed; 0 where it is none
  double standing_load = 0;    ///< and the load then
  double standing_energy = 0;  ///< stored and dissipated then [FL]
  double plateau_way = 0;      ///< displacement of the load since when it has stayed but for rounding
  double plateau_load = std::numeric_limits<double>::infinity();  ///< and the load; infinite where it is none
  bool releases = false;  ///< the last step was one of a release, at whose end more may be borne
  double load_before =
      std::numeric_limits<double>::infinity();  ///< of the point before; infinite where a leg begins
  double way_from = 0;                          ///< displacement of the load where the leg has begun
  double farthest_way = 0;                      ///< and the largest way from there
  double reloaded_way = 0;                      ///< up to which a path that seemed to unload was loaded again
  double reloaded_share = 0;                    ///< and the share of its peak borne there; -1: no equilibrium
  Standstill standstill;                        ///< of the leg, whose loads are the same
  /// The point before the present one, for `Predictor::secant`; none after a jump and where a leg begins.
  std::optional<State> before = {};
  double dissipated_before = 0;  ///< there [FL]

  /// The loads are others from here on: forgets what was measured by those before.
  void begin_stage() {
    peak_load = step = largest_displacement = last_quantum = control = 0;
    cracked_to_peak = cracked_since_peak = 0;
    direction = idle_looks = idle_turn_looks = 0;
    step_kind.reset();
    is_mechanism = releases = false;
  }

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("peak_load", self.peak_load);
    visit("direction", self.direction);
    visit("step", self.step);
    visit("largest_displacement", self.largest_displacement);
    visit("jump_energy", self.jump_energy);
    visit("last_quantum", self.last_quantum);
    visit("control", self.control);
    visit("leg", self.leg);
    visit("leg_start", self.leg_start);
    visit("surplus", self.surplus);
    visit("leg_peak", self.leg_peak);
    visit("largest_force", self.largest_force);
    visit("idle_looks", self.idle_looks);
    visit("idle_turn_looks", self.idle_turn_looks);
    visit("has_slid", self.has_slid);
    visit("moves_beside_load", self.moves_beside_load);
    visit("cracked_to_peak", self.cracked_to_peak);
    visit("cracked_since_peak", self.cracked_since_peak);
    visit("is_mechanism", self.is_mechanism);
    visit("releases", self.releases);
    visit("load_before", self.load_before);
    visit("way_from", self.way_from);
    visit("farthest_way", self.farthest_way);
    visit("reloaded_way", self.reloaded_way);
    visit("reloaded_share", self.reloaded_share);
    visit("mechanism_way", self.mechanism_way);
    visit("mechanism_load", self.mechanism_load);
    visit("beside_way", self.beside_way);
    visit("mechanism_share", self.mechanism_share);
    visit("standing_way", self.standing_way);
    visit("standing_load", self.standing_load);
    visit("standing_energy", self.standing_energy);
    visit("plateau_way", self.plateau_way);
    visit("plateau_load", self.plateau_load);
    visit("dissipated_before", self.dissipated_before);
    Standstill::visit(self.standstill, visit);
    Balance::visit(self.balance, visit);
  }
};

}  // namespace dda
