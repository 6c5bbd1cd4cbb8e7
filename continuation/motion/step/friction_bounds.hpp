#pragma once

#include <map>
#include <vector>

#include "continuation/bodies/sliders.hpp"

namespace dda {

/// The bounds μ N of friction from pass to pass of a step: the forces N of a pass follow from the bounds b of the one before,
/// and those are sought that follow from themselves.
///
///     r = μ N(b) − b,   b ← b + ω r,   ω ← −ω r₋·(r − r₋) / |r − r₋|²
///
/// ω = 1 at first. Where stiff bodies are jammed, N would go from one side of the solution to the other for ever.
/// Source of ω: Aitken's process for vectors, as couplings of solvers have it (manual of Kratos, CoSimulation, `aitken`).
class FrictionBounds {
 public:
  /// The sum of |r| over that of μ N; 0 without friction. A vertex keeps its bound where it goes to the next edge of the same
  /// body.
  double change(const std::vector<Slider>& sliders) const;
  /// Sets the bounds μ N of the next pass to b.
  void relax(std::vector<Slider>& sliders);

 private:
  using Residuals = std::map<MeetingKey, double>;
  double factor_of(const Residuals& residuals) const;

  SliderMemory used_;    ///< b
  Residuals residuals_;  ///< r of the pass before
  double factor_ = 1;    ///< ω
  bool is_begun_ = false;
};

}  // namespace dda
