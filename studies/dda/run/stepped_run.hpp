#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "studies/dda/run/run.hpp"

namespace dda {

/// A path that whoever asks for its points follows: `dda run`, and a loop in Python.
///
///     SteppedRun run(deck);                 // meshed, factorised
///     run.begin(options);                   // dead loads carried; recorded in a folder, or, without options, nowhere
///     while (const auto point = run.next()) ...
///     run.conclude();                       // what comes after the path, and the summary; only of a recorded one
class SteppedRun {
 public:
  /// Throws InputError for a deck that has no path, and for all that a scene and a model do not allow.
  explicit SteppedRun(DeckFile deck);

  /// Nothing is written.
  void begin();
  /// Makes the run folder. Throws InputError for one that may not be used, OutputError.
  void begin(const RunOptions& options);
  /// The next accepted point, recorded; nothing at the end.
  std::optional<Point> next();
  /// The path ends here, as it is told, unless it has ended before.
  void end(Ending ending);
  const Ending& ending() const { return ending_; }
  bool has_ended() const { return ending_.kind != Ending::Kind::running; }
  /// Called before each step; true ends the path as interrupted.
  void interrupt_when(std::function<bool()> asked) { simulation_.path().interrupt_when(std::move(asked)); }
  /// Goes on by another control. Throws InputError for one that cannot serve here; the path then keeps the one it has.
  void switch_control(ControlChoice control);
  /// Holds all that acts and goes on with a stage behind those of the deck. Throws InputError where the path has ended, where
  /// stages of the deck are yet to come, of a recorded one before its first step, and for loads that cannot serve; the path then
  /// goes on as it did.
  void go_on_with(StageParameters stage);

  bool is_recorded() const { return recorder_ != nullptr; }
  /// Of a recorded one: follows the primary branch, lets go what is to be let go, writes figures and summary.
  RunResult conclude();
  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }
  const DeckFile& deck() const { return deck_; }
  RunRecorder& recorder() { return *recorder_; }

 private:
  void carry_dead_loads();

  Timings timings_;
  DeckFile deck_;
  Simulation simulation_;
  RunOptions options_;
  std::unique_ptr<const RunFolder> folder_;
  std::unique_ptr<RunRecorder> recorder_;
  Ending ending_;
};

}  // namespace dda
