#pragma once

#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "continuation/solve/stepper.hpp"
#include "continuation/state/acceptance.hpp"
#include "continuation/walk/energy.hpp"
#include "continuation/walk/tangent.hpp"

namespace dda {

/// Counts of a run.
struct Effort {
  int accepted = 0;
  int cracked_steps = 0;  ///< accepted ones that LOCA has taken on the cracked points
  int whole_steps = 0;    ///< and on all unknowns
  int rejected = 0;       ///< attempts of the path that were not taken, each with a line in the log
  int rescues = 0;
  int newton_iterations = 0;   ///< on all unknowns
  int reduced_iterations = 0;  ///< on the cracked points alone
  int multiplier_iterations = 0;
  int relaxation_iterations = 0;  ///< residuals that dynamic relaxation evaluated

  /// Steps are counted from here on: those of dead loads are none of the path.
  void count_steps_anew() { accepted = cracked_steps = whole_steps = 0; }

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("accepted", self.accepted);
    visit("cracked_steps", self.cracked_steps);
    visit("whole_steps", self.whole_steps);
    visit("rejected", self.rejected);
    visit("rescues", self.rescues);
    visit("newton_iterations", self.newton_iterations);
    visit("reduced_iterations", self.reduced_iterations);
    visit("multiplier_iterations", self.multiplier_iterations);
    visit("relaxation_iterations", self.relaxation_iterations);
  }
};

/// An equilibrium that a step may accept, with all that judging it needs.
struct Candidate {
  State state;
  std::vector<History> history;
  Tangent arriving;
  std::optional<Solution> solution = {};  ///< none of what a detour has found, before NOX has confirmed it
  double dissipated = 0;                  ///< since the start of the run [FL]
  double stored = 0;                      ///< [FL]
  double work = 0;                        ///< since the start of the run [FL]
  double load = 0;                        ///< load gauge
  int newton_iterations = 0;
  double residual = 0;  ///< relative to the force level
  int multiplier_iterations = 0;
  double gap = 0;                        ///< relative, of iterated multipliers
  Excess excess = {};                    ///< over the strength of points that lose it at once
  std::optional<int> num_negative = {};  ///< eigenvalues of K below zero, every point on its surface loading
  std::optional<int> num_negative_work = {};  ///< and of its symmetric part

  /// Those that are left where the load factor yields so that the path can go on: 0 on a path without
  /// branches. A limit point changes the number of negative eigenvalues and the sign of the load factor's
  /// rate together, a bifurcation the former alone.
  std::optional<int> surplus() const {
    if (!num_negative) return {};
    return std::abs(*num_negative - (arriving.load_factor < 0 ? 1 : 0));
  }

  /// The numbers that a walker which stands here needs of how it came; state and history are kept by themselves.
  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("dissipated", self.dissipated);
    visit("stored", self.stored);
    visit("work", self.work);
    visit("load", self.load);
    visit("residual", self.residual);
    visit("arriving_load_factor", self.arriving.load_factor);
    visit("num_negative", self.num_negative);
    visit("num_negative_work", self.num_negative_work);
  }
};

/// Stands on an equilibrium of the path, tries steps from it, and moves when one is kept.
///
/// Owns no law and no equation: it puts together system, tangents, energies and LOCA steps.
class Walker {
 public:
  explicit Walker(Stepper& stepper);

  Stepper& stepper() { return stepper_; }
  const Stepper& stepper() const { return stepper_; }
  System& system() { return system_; }
  const System& system() const { return system_; }
  const State& state() const { return here_.state; }
  const Candidate& here() const { return here_; }
  const Tangent& leaving() const { return leaving_; }
  const Effort& effort() const { return effort_; }
  Effort& effort() { return effort_; }
  const StepperParameters& parameters() const { return stepper_.parameters(); }
  double value(const Functional& gauge) const { return here_.state.value(gauge); }

  /// Tries a step under a control; Newton starts from the guess.
  Attempt attempt(ControlEquation& control, double step, const State& guess,
                  Thoroughness thoroughness = Thoroughness::usual);
  /// Everything about a converged attempt; the walker stays where it is.
  Candidate evaluate(const Attempt& attempt);
  /// Moves to a candidate that has a solution, and has LOCA take the step.
  void accept(Candidate candidate);
  /// An equilibrium that no continuous step led to, with its residual.
  Candidate settled(const Settled& found);
  /// Whether NOX converges where a candidate without a solution stands, its load factor held; then it has one.
  bool confirm(Candidate& candidate);
  /// Moves there; returns the energy released on the way [FL].
  double jump(Candidate next);

  /// The point that lies `amount` further along the leaving tangent, in its own unit.
  State ahead(double amount) const;

  /// From here on ways along which no crack grows are taken by this heading.
  void head_for(std::optional<Heading> heading) { heading_ = std::move(heading); }
  /// Leaves the damage surfaces: from here on nothing loads or slides until it is reached again.
  void unload();
  /// Leaves a change of contact by what goes on beyond it, if the tangent would lead straight back.
  void leave_beyond(BeyondChange change);
  /// Goes on by another tangent, with the history's flags that belong to it.
  void turn_to(Tangent leaving, std::vector<History> flags);

  /// Lets the equilibrium be made anew, with other cuts, and stands where it stood, new cuts closed: no equilibrium
  /// yet, and without a tangent.
  Growth follow(const std::function<Growth()>& remake);
  /// Energy that was stored in what is no part of the structure any more [FL].
  void leave_behind(double energy) {
    here_.stored -= energy;
    here_.work -= energy;
  }
  /// Starts the next stage at the present state with load factor 0.
  void begin_stage(std::size_t stage);
  /// The path leaves as a stage begins: its load has not set out yet.
  void set_out();
  /// Puts the walker on a stored equilibrium with the tangent by which it was about to leave: computed anew,
  /// with another base of the linear system, it would differ in its last digits.
  void restore(Candidate at, const Effort& effort, Tangent leaving);

 private:
  void take(const Solution& solution);
  /// Adds what NOX has done since the last time.
  void count_iterations();
  void fill_energies(Candidate& candidate);
  double work_up_to(const Candidate& candidate, const Stretch& step) const;
  /// The tangent with the flags of the system's history, and the inertia of its stiffness.
  void fill_arriving(Candidate& candidate);

  Stepper& stepper_;
  System& system_;
  Candidate here_;
  Tangent leaving_;
  std::optional<Heading> heading_;
  Effort effort_;
};

}  // namespace dda
