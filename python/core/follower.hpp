#pragma once

#include <atomic>
#include <optional>

#include "continuation/stability/stiffness_modes.hpp"
#include "python/core/followed.hpp"
#include "python/core/matrices.hpp"

namespace dda::python {

/// How a deck comes from Python: its text, the name of its file, and settings as of `--set`.
struct GivenDeck {
  std::string text, name;
  std::vector<std::string> settings;
  bool is_dictionary = false;  ///< places in messages are then the keys, not lines of the text
};

/// Follows a path for a loop in Python. Every function but the constructor is called by one thread at a time, with the
/// interpreter's lock, which it lets go of while it computes.
class Follower {
 public:
  explicit Follower(const GivenDeck& deck);

  void begin(const std::optional<RunOptions>& recorded);
  /// The next accepted point; null at the end. Throws pybind11::error_already_set for Ctrl-C, and for what a law in
  /// Python raises: the path has then ended.
  std::shared_ptr<AcceptedPoint> next();
  /// Where the path stands: the last point, or its start.
  std::shared_ptr<AcceptedPoint> here() const { return here_; }
  const Ending& ending() const { return run().ending(); }
  void end(Ending ending) { run().end(std::move(ending)); }
  /// Writes what a run folder has at its end; nothing without one. The folder's name, "" without.
  std::string conclude();

  std::string control() const;
  void switch_control(const std::string& yaml);
  /// Holds all that acts, and goes on with a stage.
  void go_on_with(const std::string& yaml);
  double next_step() const;
  void set_next_step(double size);

  /// K with the damage and the flags of the last point: its symmetric part.
  BlockRows stiffness() const;
  /// K φ = μ M φ, the lowest `count`: M is identities, or of density 1 or those of the materials, each of which then needs
  /// one.
  StiffnessModes modes(int count, EigenvalueMass mass);
  /// R there, and f = f_dead + λ f_reference.
  std::vector<double> residual() const;
  std::vector<double> load_vector() const;
  const std::vector<double>& reference_load() const;

  SteppedRun& run() { return followed_->run(); }
  const SteppedRun& run() const { return followed_->run(); }
  const Followed& followed() const { return *followed_; }

 private:
  std::shared_ptr<AcceptedPoint> point_here(Point point) const;

  std::shared_ptr<Followed> followed_;
  std::shared_ptr<AcceptedPoint> here_;
  bool is_concluded_ = false;
};

}  // namespace dda::python
