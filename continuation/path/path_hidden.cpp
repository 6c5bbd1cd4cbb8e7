// What a converged step may hide between its ends: a peak at a corner of some law, a gauge that turns back
// and forward again.
#include <algorithm>
#include <cmath>

#include "continuation/path/path.hpp"

namespace dda {
namespace {

/// A scalar at both ends of a step with its changes over the whole step by the tangents there.
struct Course {
  double from, to, leaving, arriving;

  /// What the trapezoid of both rates misses: third order where the course is smooth, and of the height of
  /// what is hidden where it has corners.
  double kink() const { return std::abs(to - from - 0.5 * (leaving + arriving)); }

  bool turns() const { return leaving * arriving < 0; }
  /// Share of the step at which both tangents meet: where a course of one corner has it.
  double meeting() const { return (to - from - arriving) / (leaving - arriving); }
  /// By how much that place lies beyond both ends: a bound of what a course of one bend cuts off.
  double cut_off() const {
    const double share = std::clamp(meeting(), 0.0, 1.0);
    return std::min(std::abs(share * leaving), std::abs((1 - share) * arriving));
  }

  /// By how much a course that leaves and arrives in the same direction may have turned back between at most:
  /// the way that it is short of the faster of its rates.
  double turned_back() const {
    const double direction = leaving < 0 ? -1 : 1;
    return std::max(direction * leaving, direction * arriving) - direction * (to - from);
  }
};

Course course_of(const Functional& gauge, const Walker& walker, const Candidate& candidate) {
  const double dissipated = candidate.dissipated - walker.here().dissipated;
  return {walker.value(gauge), gauge.value(candidate.state.d, candidate.state.load_factor),
          walker.leaving().rate(gauge) * dissipated, candidate.arriving.rate(gauge) * dissipated};
}

/// Looks in a row that may find nothing.
constexpr int most_idle_looks = 10;

bool is_smooth(const Walker& walker, const Candidate& candidate) {
  return candidate.dissipated > walker.here().dissipated && walker.leaving().dissipates &&
         candidate.arriving.dissipates;
}

}  // namespace

/// What a turn of a gauge is measured by: its largest value so far; of one that hardly moves beside the
/// displacement of the load, that one's hundredth.
double Path::size_of_gauge(const NamedGauge& gauge, const Candidate& candidate) const {
  constexpr double hardly = 0.01;
  const Travel& travel = memory_.travels.at(gauge.name);
  const double now = gauge.functional.value(candidate.state.d, candidate.state.load_factor);
  return std::max({std::abs(travel.from), std::abs(travel.farthest), std::abs(now),
                   hardly * memory_.largest_displacement});
}

/// Share of the step at which a displacement gauge turns, where the rows at both ends would show the turn
/// lower than it is by half the depth of one that is to be seen: so that a turn and the next, each cut off,
/// stay two.
std::optional<double> Path::before_turn(const Candidate& candidate) const {
  if (!is_smooth(walker_, candidate)) return {};
  std::optional<double> first;
  for (const NamedGauge& gauge : travelling_) {
    if (gauge.dimension != dimension::length) continue;
    const Course course = course_of(gauge.functional, walker_, candidate);
    if (!course.turns() || course.cut_off() <= 0.5 * turn_depth * size_of_gauge(gauge, candidate)) continue;
    first = std::min(first.value_or(1), course.meeting());
  }
  if (!first) return {};
  return std::clamp(*first, 0.1, 0.9);
}

/// Whether the load may have turned above the peak by more than half of its tolerance. So many looks in a row
/// that found no higher load end them: a plateau has corners in every step.
bool Path::may_hide_peak(const Candidate& candidate) const {
  if (memory_.idle_looks >= most_idle_looks) return false;
  const double sign = memory_.direction < 0 ? -1 : 1;
  const Course load = course_of(load_, walker_, candidate);
  const double highest = std::max({sign * load.from, sign * load.to, memory_.peak_load});
  const double top = std::max(sign * load.from, sign * load.to) + load.kink();
  const bool rises_on = sign * load.to >= highest && sign * load.arriving > 0;  // the peak is still ahead
  return !rises_on && top > highest * (1 + 0.5 * parameters_.peak_tolerance);
}

/// Whether a displacement gauge may have turned back and forward again by more than the depth that is to be
/// seen. A turn back by d between two ways forward leaves a kink of d and of what the way forward lacks; the
/// bend of a smooth step at the default accuracy leaves up to two such depths. So many looks in a row that
/// found no turn end them, until the next one.
bool Path::may_hide_turns(const Candidate& candidate) const {
  if (memory_.idle_turn_looks >= most_idle_looks) return false;
  constexpr double smooth = 3;
  return std::ranges::any_of(travelling_, [&](const NamedGauge& gauge) {
    if (gauge.dimension != dimension::length) return false;
    const Course course = course_of(gauge.functional, walker_, candidate);
    const double depth = turn_depth * size_of_gauge(gauge, candidate);
    return course.kink() > smooth * depth && !course.turns() && course.turned_back() > depth;
  });
}

/// Whether a displacement gauge turns within the step.
bool Path::turns(const Candidate& candidate) const {
  if (!is_smooth(walker_, candidate)) return false;
  constexpr double noticeable = 1e-3;
  return std::ranges::any_of(travelling_, [&](const NamedGauge& gauge) {
    if (gauge.dimension != dimension::length) return false;
    const Course course = course_of(gauge.functional, walker_, candidate);
    return course.turns() && course.cut_off() > noticeable * turn_depth * size_of_gauge(gauge, candidate);
  });
}

/// Counts the looks that found nothing.
void Path::note_looks(const Looks& looks, const Candidate& candidate) {
  if (looks.for_peak) {
    const bool is_new = load_of(candidate.state) > memory_.peak_load * (1 + parameters_.peak_tolerance);
    memory_.idle_looks = is_new ? 0 : memory_.idle_looks + 1;
  }
  if (turns(candidate))
    memory_.idle_turn_looks = 0;
  else if (looks.for_turn)
    ++memory_.idle_turn_looks;
}

/// Share of the step after which it is to be looked at: the next corner of a law, or half way. Asked for
/// where a peak or a turn may be hidden; nothing elsewhere.
std::optional<double> Path::before_hidden_turn(const Candidate& candidate, double amount) const {
  if (!is_smooth(walker_, candidate)) return {};
  if (!may_hide_peak(candidate) && !may_hide_turns(candidate)) return {};
  const double corner = std::min(next_corner(walker_), next_new_crack(walker_)) / amount;
  constexpr double nearest = 0.1, farthest = 0.9, half = 0.5;
  return corner > nearest && corner < farthest ? corner : half;
}

}  // namespace dda
