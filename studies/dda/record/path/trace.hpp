#pragma once

#include <limits>
#include <vector>

#include "continuation/walk/walker.hpp"
#include "studies/dda/record/measures.hpp"

namespace dda {

/// An accepted state with the tangents of the path on its two sides, per unit of dissipated energy.
///
/// A side on which nothing dissipates has no such tangent: not a number. rate[0] belongs to the load, the
/// others to the displacement gauges in the order of Measures::displacements.
struct TracePoint {
  double dissipated = 0, load = 0;
  std::vector<double> displacements;
  std::vector<double> arriving, leaving;
};

/// The state at which the walker stands.
TracePoint trace_point(const Walker& walker, const Measures& measures);

}  // namespace dda
