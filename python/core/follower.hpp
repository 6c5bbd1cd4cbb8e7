#pragma once

#include <atomic>
#include <optional>
#include <thread>

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

/// Follows a path for a loop in Python. Every function but the constructor is called with the interpreter's lock, which it lets go
/// of while it computes; another thread that calls one meanwhile is refused by std::runtime_error.
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

  SteppedRun& run() {
    require_turn();
    return followed_->run();
  }
  const SteppedRun& run() const {
    require_turn();
    return followed_->run();
  }
  const Followed& followed() const { return *followed_; }

 private:
  /// While there is one, other threads are refused.
  class Turn {
   public:
    explicit Turn(const Follower& of);
    ~Turn();
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;

   private:
    const Follower& of_;
    bool is_first_ = false;  ///< of this thread
  };

  void require_turn() const;
  std::shared_ptr<AcceptedPoint> point_here(Point point) const;

  std::shared_ptr<Followed> followed_;
  std::shared_ptr<AcceptedPoint> here_;
  bool is_concluded_ = false;
  mutable std::atomic<std::thread::id> computes_{std::thread::id{}};  ///< the thread that does; none
};

}  // namespace dda::python
