// What a converged step may hide between its ends: a peak at a corner of some law.
#include <algorithm>
#include <cmath>

#include "continuation/path.hpp"

namespace dda {
namespace {

/// A scalar at both ends of a step with its changes over the whole step by the tangents there.
struct Course {
  double from, to, leaving, arriving;

  /// What the trapezoid of both rates misses: third order where the course is smooth, and of the height of
  /// what is hidden where it has corners.
  double kink() const { return std::abs(to - from - 0.5 * (leaving + arriving)); }
};

}  // namespace

/// Share of the step after which it is to be looked at: the next corner of a law, or half way. Asked for
/// where the load may have turned above the peak by more than half of its tolerance; nothing elsewhere.
std::optional<double> Path::before_hidden_turn(const Candidate& candidate, double amount) const {
  const double dissipated = candidate.dissipated - walker_.here().dissipated;
  if (dissipated <= 0 || !walker_.leaving().dissipates || !candidate.arriving.dissipates) return {};
  const double sign = memory_.direction < 0 ? -1 : 1;
  const Course load{load_.value(walker_.state().d, walker_.state().load_factor),
                    load_.value(candidate.state.d, candidate.state.load_factor),
                    walker_.leaving().rate(load_) * dissipated, candidate.arriving.rate(load_) * dissipated};
  const double highest = std::max({sign * load.from, sign * load.to, memory_.peak_load});
  const double top = std::max(sign * load.from, sign * load.to) + load.kink();
  const bool rises_on = sign * load.to >= highest && sign * load.arriving > 0;  // the peak is still ahead
  const bool hides = !rises_on && top > highest * (1 + 0.5 * parameters_.peak_tolerance);
  if (!hides) return {};
  const double corner = std::min(next_corner(walker_), next_new_crack(walker_)) / amount;
  constexpr double nearest = 0.1, farthest = 0.9, half = 0.5;
  return corner > nearest && corner < farthest ? corner : half;
}

}  // namespace dda
