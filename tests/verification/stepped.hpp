#pragma once

#include "continuation/solve/stepper.hpp"
#include "verification/support.hpp"

namespace dda::verification {

/// A structure whose load factor is prescribed step by step, each step accepted when it converges.
class Stepped {
 public:
  explicit Stepped(const std::string& deck_text, const MultiplierParameters& multipliers = {});

  /// To this load factor of the present stage.
  Attempt to(double load_factor);
  /// The present stage stays as it stands; the next begins at load factor 0.
  void next_stage();

  const State& state() const { return state_; }
  const System& system() const { return system_; }
  double gauge(const std::string& name) const;
  double reaction(const std::string& name) const;
  Vec2 traction(std::size_t point) const;
  /// Σ W t over all active points [F].
  Vec2 force() const;
  /// Jump of displacement g of an active point, (n, s) [L].
  Vec2 jump(std::size_t point) const;

 private:
  /// When the load turns round, what loaded unloads and what slid sticks.
  void turn_back();
  LawValues laws() const { return system_.laws(state_); }

  Structure structure_;
  System system_;
  Stepper stepper_;
  std::size_t stage_ = 0;
  State state_;
  double last_change_ = 0;  ///< of the load factor in the step before
};

}  // namespace dda::verification
