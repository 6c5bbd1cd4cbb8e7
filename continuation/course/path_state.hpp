#pragma once

#include <functional>
#include <memory>

#include "continuation/course/path_parameters.hpp"
#include "continuation/course/point.hpp"
#include "continuation/walk/walker.hpp"

namespace dda {

/// Gauges of a path and what it is to pass, looked up in the equilibrium as it is.
struct Aims {
  GaugeBook gauges;
  Route route;
};

/// Why and where the loads of a stage are held.
struct StageEnd {
  double load_factor = 0;
  std::string reason;
};

/// Loads that are followed one after another.
struct LaterStages {
  /// Holds the loads as they are, puts the walker at the beginning of the next stage, and looks up its gauges.
  std::function<Aims(const StageEnd&)> hold;
  std::function<void()> has_begun;  ///< and the path has forgotten the loads before
};

/// Cracks that may run through the blocks while a path is followed.
struct RunningCracks {
  CrackedStructure& structure;
  std::function<Aims()> look_up;                 ///< whenever the equilibrium has been made anew
  std::function<void()> grows;                   ///< told to whoever keeps states, before anything changes
  std::function<void(const Growth&)> has_grown;  ///< and after it
};

/// What following a path knows and remembers: where the walker stands, what the deck wants, and how the path
/// has gone so far. Judging, landings, pace and the kinds of steps are functions of it.
struct PathState {
  PathState(Walker& stands, const PathParameters& wanted, const GaugeBook& gauges, Route way);

  /// Looks its gauges up again, the equilibrium having been made anew.
  void look_up(const Aims& aims);
  /// The load, positive in the direction of the first loading.
  double load_of(const State& state) const;
  /// A force as a load: where that is the load factor of loads without a resultant, the one at which they are as large.
  double as_load(double force) const { return load_per_force * force; }
  /// What a load that is no force works on, as a displacement [L].
  double as_length(double work_per_load) const { return load_per_force * work_per_load; }
  /// A load below this is none: the tolerances of the equilibria leave as much of the other forces.
  double smallest_load() const;
  /// What it still bears of the peak of its load; 1 where it has borne none.
  double share_of_peak() const;
  /// The displacement on which the load works, and its rate.
  double displacement_of(const State& state) const;
  double displacement_rate(const Tangent& tangent) const;
  const Leg& leg() const { return route.legs[static_cast<std::size_t>(memory.leg)]; }
  /// Whether the leg after the present one has loads of its own.
  bool is_last_of_stage() const {
    return !is_last_leg() && route.legs[static_cast<std::size_t>(memory.leg) + 1].has_loads;
  }
  bool is_last_leg() const { return static_cast<std::size_t>(memory.leg) + 1 == route.legs.size(); }

  /// Ends the path; where equilibria were found that are no results, by them. Nothing, for the caller to
  /// return.
  std::optional<Point> end(Ending::Kind kind, std::string reason);
  std::optional<Point> stop_early(Stop stop, std::string reason);
  /// Ends it where the structure leads no further, which is a goal unless stages are left that were to follow.
  std::optional<Point> end_with_structure(std::string reason);
  /// Counts a step that is not taken, remembers why, and tells the log.
  void reject(const std::string& control, const std::string& why);
  void report(const std::string& event, const std::string& text) const {
    if (listener) listener(event, text);
  }

  Walker& walker;
  const PathParameters& parameters;
  std::unique_ptr<Control> control;
  Functional load;
  double load_per_force = 1;  ///< 1, or 1/‖f_ref‖ where the load is the load factor [1/F]
  Functional displacement;    ///< on which the load works
  Route route;
  std::vector<NamedGauge> travelling;  ///< whose travel is remembered
  bool releases_at_once = false;       ///< some law does
  int most_steps = 0;                  ///< of the run
  std::optional<RunningCracks> cracks;
  std::optional<LaterStages> later_stages;
  double size = 0;      ///< of the structure [L]
  std::string refusal;  ///< why the last try has not been taken
  bool is_refused_beside_load =
      false;  ///< it was since joints move far while the load and its displacement stay
  /// What the last candidate of this step was refused for, beside equilibrium.
  std::optional<Stopped> unsound;
  PathMemory memory;
  Ending ending;
  std::function<void(const std::string& event, const std::string& text)> listener;  ///< the log

 private:
  void end_unsound(const std::string& reason);
};

}  // namespace dda
