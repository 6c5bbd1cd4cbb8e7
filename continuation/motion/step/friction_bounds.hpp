#pragma once

#include <Eigen/Core>
#include <deque>
#include <vector>

#include "continuation/bodies/sliders.hpp"
#include "continuation/motion/energy/potential.hpp"

namespace dda {

/// What bounds a friction: μ N as it follows from a place, or as a pass takes it.
struct FrictionBound {
  MeetingKey key;
  double force = 0;  ///< [F]
};

/// All that rubs at a place.
struct Rubbing {
  std::vector<Slider> sliders;
  std::vector<RubbingBond> bonds;

  bool empty() const { return sliders.empty() && bonds.empty(); }
  /// Sliders first. Bonds have keys of their own: bodies that are joined do not meet.
  std::vector<FrictionBound> bounds(const std::vector<Bond>& all) const;
  void set_bounds(const std::vector<FrictionBound>& bounds);
};

/// The bounds μ N of friction from pass to pass of a step: the forces N of a pass follow from the bounds b of the one before,
/// and those are sought that follow from themselves.
///
///     r = μ N(b) − b,   b ← b + ω r,   ω ← −ω r₋·(r − r₋) / |r − r₋|²
///
/// ω = 1 at first. Where stiff bodies are jammed, N would go from one side of the solution to the other for ever. Residuals that
/// turn from pass to pass, as of three bodies that wedge each other, have no such ω: after some passes (Anderson's acceleration)
///
///     b ← b + ω r − (ΔB + ω ΔR) γ,   |r − ΔR γ| least
///
/// with the changes ΔB and ΔR of the last few passes. A contact that is gone has μ N = 0.
/// Source of ω: Aitken's process for vectors, as couplings of solvers have it (manual of Kratos, CoSimulation, `aitken`).
class FrictionBounds {
 public:
  /// The sum of |r| over that of μ N; 0 without friction. A vertex keeps its bound where it goes to the next edge of the same
  /// body.
  double change(const std::vector<FrictionBound>& asked) const;
  /// Sets the bounds μ N of the next pass to b.
  void relax(std::vector<FrictionBound>& asked);

 private:
  struct Bound {
    MeetingKey key;
    double used = 0;      ///< b [F]
    double residual = 0;  ///< r [F]
  };
  using Pass = std::vector<Bound>;  ///< in the order of its keys

  Pass pass_of(const std::vector<FrictionBound>& asked) const;
  static Bound at(const Pass& pass, const MeetingKey& key);
  double factor_of(const Pass& now);
  Eigen::VectorXd next_of(const Pass& now) const;

  SliderMemory used_;      ///< b
  std::deque<Pass> past_;  ///< the last passes, the latest last
  double factor_ = 1;      ///< ω
  int passes_ = 0;         ///< so far
  bool grows_ = false;     ///< the residuals, along themselves
};

}  // namespace dda
