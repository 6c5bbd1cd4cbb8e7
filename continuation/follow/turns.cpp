#include "continuation/follow/turns.hpp"

#include <algorithm>
#include <cmath>

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

/// Looks in a row that may find nothing.
constexpr int most_idle_looks = 10;

/// By what the rates at both ends of a step are to be multiplied to be changes over it.
struct Spans {
  double leaving, arriving;
};

/// The energy that is spent in it; nothing where cracks do not grow at both ends.
std::optional<Spans> cracking_spans(const Walker& walker, const Candidate& candidate) {
  const double dissipated = candidate.dissipated - walker.here().dissipated;
  const bool grows = dissipated > 0 && walker.leaving().dissipates && candidate.arriving.dissipates;
  return grows ? std::optional(Spans{dissipated, dissipated}) : std::nullopt;
}

/// Where none grows and contacts change, the displacement of the load over its rate. Nothing where neither runs on from end
/// to end, and under a load that is rounding.
std::optional<Spans> spans(const PathState& path, const Candidate& candidate) {
  const Walker& walker = path.walker;
  if (const auto cracking = cracking_spans(walker, candidate)) return cracking;
  if (walker.leaving().dissipates || candidate.arriving.dissipates || !walker.system().has_contacts())
    return {};
  if (std::max(std::abs(path.load_of(walker.state())), std::abs(path.load_of(candidate.state))) <=
      path.smallest_load())
    return {};
  const double moved = path.displacement_of(candidate.state) - path.displacement_of(walker.state());
  const Spans out{moved / path.displacement_rate(walker.leaving()),
                  moved / path.displacement_rate(candidate.arriving)};
  const bool runs_on = out.leaving > 0 && out.arriving > 0 && std::isfinite(out.leaving + out.arriving);
  return runs_on ? std::optional(out) : std::nullopt;
}

Course course_of(const Functional& gauge, const Walker& walker, const Candidate& candidate,
                 const Spans& over) {
  return {walker.value(gauge), candidate.state.value(gauge), walker.leaving().rate(gauge) * over.leaving,
          candidate.arriving.rate(gauge) * over.arriving};
}

/// What a turn of a gauge is measured by: its largest value so far; of one that hardly moves beside the
/// displacement of the load, that one's hundredth.
double size_of_gauge(const PathState& path, const NamedGauge& gauge, const Candidate& candidate) {
  constexpr double hardly = 0.01;
  const Travel& travel = path.memory.travels.at(gauge.name);
  const double now = candidate.state.value(gauge.functional);
  return std::max({std::abs(travel.from), std::abs(travel.farthest), std::abs(now),
                   hardly * path.memory.largest_displacement});
}

/// Whether a displacement gauge turns within the step.
bool turns(const PathState& path, const Candidate& candidate) {
  const auto over = cracking_spans(path.walker, candidate);
  if (!over) return false;
  constexpr double noticeable = 1e-3;
  return std::ranges::any_of(path.travelling, [&](const NamedGauge& gauge) {
    if (gauge.dimension != dimension::length) return false;
    const Course course = course_of(gauge.functional, path.walker, candidate, *over);
    return course.turns() &&
           course.cut_off() > noticeable * turn_depth * size_of_gauge(path, gauge, candidate);
  });
}

}  // namespace

std::optional<double> before_peak(const PathState& path, const Candidate& candidate) {
  const auto over = spans(path, candidate);
  if (!over) return {};
  const double sign = path.memory.direction < 0 ? -1 : 1;
  const Course load = course_of(path.load, path.walker, candidate, *over);
  if (sign * load.leaving <= 0 || sign * load.arriving >= 0) return {};
  const double share = load.meeting(), top = sign * (load.from + share * load.leaving),
               highest = std::max({sign * load.from, sign * load.to, path.memory.peak_load});
  if (top <= highest * (1 + path.parameters.peak_tolerance)) return {};
  return std::clamp(share, 0.1, 0.9);
}

std::optional<double> before_turn(const PathState& path, const Candidate& candidate) {
  const auto over = cracking_spans(path.walker, candidate);
  if (!over) return {};
  std::optional<double> first;
  for (const NamedGauge& gauge : path.travelling) {
    if (gauge.dimension != dimension::length) continue;
    const Course course = course_of(gauge.functional, path.walker, candidate, *over);
    if (!course.turns() || course.cut_off() <= 0.5 * turn_depth * size_of_gauge(path, gauge, candidate))
      continue;
    first = std::min(first.value_or(1), course.meeting());
  }
  if (!first) return {};
  return std::clamp(*first, 0.1, 0.9);
}

std::optional<double> before_hidden_turn(const PathState& path, const Candidate& candidate, double amount) {
  if (!may_hide_peak(path, candidate) && !may_hide_turns(path, candidate)) return {};
  const double corner = std::min(next_corner(path.walker), next_new_crack(path.walker)) / amount;
  constexpr double nearest = 0.1, farthest = 0.9, half = 0.5;
  return corner > nearest && corner < farthest ? corner : half;
}

bool may_hide_peak(const PathState& path, const Candidate& candidate) {
  const auto over = spans(path, candidate);
  if (!over || path.memory.idle_looks >= most_idle_looks) return false;
  const double sign = path.memory.direction < 0 ? -1 : 1;
  const Course load = course_of(path.load, path.walker, candidate, *over);
  const double highest = std::max({sign * load.from, sign * load.to, path.memory.peak_load});
  const double top = std::max(sign * load.from, sign * load.to) + load.kink();
  const bool rises_on = sign * load.to >= highest && sign * load.arriving > 0;  // the peak is still ahead
  // Where contacts change a course that rises to a plateau has a kink as large as one that has turned.
  const bool has_turned =
      cracking_spans(path.walker, candidate) || (sign * (load.from - load.to) > 0 && sign * load.leaving > 0);
  return has_turned && !rises_on && top > highest * (1 + 0.5 * path.parameters.peak_tolerance);
}

bool may_hide_turns(const PathState& path, const Candidate& candidate) {
  const auto over = cracking_spans(path.walker, candidate);
  if (!over || path.memory.idle_turn_looks >= most_idle_looks) return false;
  constexpr double smooth = 3;
  return std::ranges::any_of(path.travelling, [&](const NamedGauge& gauge) {
    if (gauge.dimension != dimension::length) return false;
    const Course course = course_of(gauge.functional, path.walker, candidate, *over);
    const double depth = turn_depth * size_of_gauge(path, gauge, candidate);
    return course.kink() > smooth * depth && !course.turns() && course.turned_back() > depth;
  });
}

void note_looks(PathState& path, const Looks& looks, const Candidate& candidate) {
  if (looks.for_peak) {
    const bool is_new =
        path.load_of(candidate.state) > path.memory.peak_load * (1 + path.parameters.peak_tolerance);
    path.memory.idle_looks = is_new ? 0 : path.memory.idle_looks + 1;
  }
  if (turns(path, candidate))
    path.memory.idle_turn_looks = 0;
  else if (looks.for_turn)
    ++path.memory.idle_turn_looks;
}

}  // namespace dda
