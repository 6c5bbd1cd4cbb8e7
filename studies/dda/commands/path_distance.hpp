#pragma once

#include <vector>

#include "studies/dda/record/path/trace.hpp"

namespace dda {

/// How far two paths of one structure lie apart, relative to the peak of the first.
struct PathDistance {
  /// Largest difference of load at equal dissipated energy; of displacement in the elastic part.
  double load = 0;
  double hausdorff = 0;  ///< symmetric Hausdorff distance in (u/u_peak, F/F_peak)
};

/// Compares the part that both paths cover, up to the smaller dissipated energy; u is the first displacement
/// gauge.
///
/// A snap-back is multi-valued in displacement, so states are matched by their dissipated energy D, on which
/// the paths are interpolated with their own tangents dF/dD and du/dD: by cubic Hermite polynomials, and, for
/// steps within which a point starts to crack, by the two tangents up to where they meet. Accepted states are
/// measured against the nearer of both.
PathDistance distance(const std::vector<TracePoint>& first, const std::vector<TracePoint>& second);

/// Largest difference of load, relative to the peak of the first, where both paths have a step on the same
/// wanted value of displacement gauge k: exact, nothing is interpolated. Not a number when they share none.
double difference_at(const std::vector<TracePoint>& first, const std::vector<TracePoint>& second,
                     std::size_t k, const std::vector<double>& values);

}  // namespace dda
