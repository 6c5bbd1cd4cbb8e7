#pragma once

#include <cmath>
#include <cstddef>

#include "continuation/solve/stepper.hpp"

namespace dda {

/// Watches the gap of iterated multipliers for whether it can come down to its tolerance in the iterations
/// that are left.
///
/// The iteration is linear as long as no point changes its piece: the gap is a sum of Σ aᵢ cᵢⁿ, |cᵢ| < 1,
/// whose slowest part outlives the others, so that its fall in a stretch of iterations is more than in any
/// later one. Where joints lock, because corners of the bodies do not meet, cᵢ comes as near to 1 as 1 −
/// 1e-5. A stretch in which a piece changes says nothing; of the others two must say the same.
class Settling {
 public:
  explicit Settling(const MultiplierParameters& parameters) : parameters_(parameters) {}

  /// Called with each gap above the tolerance, in turn, and the pieces at it (System::active_set).
  bool is_out_of_reach(double gap, std::size_t pieces) {
    ++iterations_;
    if (pieces != pieces_ || before_ == 0) {
      pieces_ = pieces;
      begin_ = iterations_;
      before_ = gap;
    }
    if (iterations_ - begin_ < stretch) return false;
    const double left = parameters_.max_iterations - iterations_, fall = std::log(before_ / gap) / stretch;
    const bool reaches = fall * left >= std::log(gap / parameters_.tolerance);
    begin_ = iterations_;
    before_ = gap;
    short_falls_ = reaches ? 0 : short_falls_ + 1;
    return short_falls_ == 2;
  }

 private:
  static constexpr int stretch = 20;
  const MultiplierParameters& parameters_;
  double before_ = 0;  ///< gap at the begin of the stretch
  std::size_t pieces_ = 0;
  int begin_ = 0, iterations_ = 0, short_falls_ = 0;
};

}  // namespace dda
