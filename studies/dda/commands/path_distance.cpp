#include "studies/dda/commands/path_distance.hpp"

#include <algorithm>
#include <cmath>

namespace dda {
namespace {

using Trace = std::vector<TracePoint>;

/// A state of a path between its steps.
struct Sample {
  double dissipated, displacement, load;
};
using Samples = std::vector<Sample>;

double displacement(const TracePoint& at) { return at.displacements.empty() ? 0 : at.displacements.front(); }

struct ValueAndSlope {
  double value, slope;
};

/// Cubic Hermite at the share s of an interval of length h; linear when a slope is not known.
double hermite(const ValueAndSlope& a, const ValueAndSlope& b, double h, double s) {
  if (!std::isfinite(a.slope) || !std::isfinite(b.slope)) return a.value + s * (b.value - a.value);
  const double s2 = s * s, s3 = s2 * s;
  return (2 * s3 - 3 * s2 + 1) * a.value + (s3 - 2 * s2 + s) * h * a.slope + (3 * s2 - 2 * s3) * b.value +
         (s3 - s2) * h * b.slope;
}

/// Share of the step at which the tangents of its two ends meet; not a number when they do not meet inside.
///
/// There lies the kink when a point starts to crack within the step.
double meeting(const TracePoint& a, const TracePoint& b, double h) {
  const double share = (b.load - a.load - h * b.arriving[0]) / (h * (a.leaving[0] - b.arriving[0]));
  return share > 0 && share < 1 ? share : std::numeric_limits<double>::quiet_NaN();
}

/// What a path is taken to be between two steps: smooth, or with one kink.
enum class Between { hermite, tangents };

Sample on_tangents(const TracePoint& a, const TracePoint& b, double s, double kink) {
  const double h = b.dissipated - a.dissipated;
  const auto value = [&](double from, double to, std::size_t i) {
    return s < kink ? from + s * h * a.leaving[i] : to - (1 - s) * h * b.arriving[i];
  };
  Sample out{a.dissipated + s * h, 0, value(a.load, b.load, 0)};
  if (!a.displacements.empty()) out.displacement = value(displacement(a), displacement(b), 1);
  return out;
}

Sample between(const TracePoint& a, const TracePoint& b, double s, Between kind) {
  const double h = b.dissipated - a.dissipated;
  const double kink =
      kind == Between::tangents && h > 0 ? meeting(a, b, h) : std::numeric_limits<double>::quiet_NaN();
  if (std::isfinite(kink)) return on_tangents(a, b, s, kink);
  Sample out{a.dissipated + s * h, 0, hermite({a.load, a.leaving[0]}, {b.load, b.arriving[0]}, h, s)};
  if (!a.displacements.empty())
    out.displacement = hermite({displacement(a), a.leaving[1]}, {displacement(b), b.arriving[1]}, h, s);
  return out;
}

/// The path as a fine polyline up to the dissipated energy `end`.
Samples samples(const Trace& trace, double end, Between kind) {
  constexpr int per_step = 16;
  Samples out{{trace[0].dissipated, displacement(trace[0]), trace[0].load}};
  for (std::size_t i = 0; i + 1 < trace.size(); ++i) {
    const double h = trace[i + 1].dissipated - trace[i].dissipated;
    const double last = h > 0 ? std::min(1.0, (end - trace[i].dissipated) / h) : 1.0;
    for (int k = 1; k <= per_step; ++k)
      out.push_back(between(trace[i], trace[i + 1], last * k / per_step, kind));
    if (last < 1) break;
  }
  return out;
}

/// Linear interpolation of fine samples on a quantity that grows along them.
template <class Key, class Value>
double lookup(const Samples& path, double key, Key key_of, Value value_of) {
  const auto above = std::ranges::lower_bound(path, key, {}, key_of);
  if (above == path.begin()) return value_of(path.front());
  if (above == path.end()) return value_of(path.back());
  const Sample &a = *std::prev(above), &b = *above;
  const double s = (key - key_of(a)) / (key_of(b) - key_of(a));
  return value_of(a) + s * (value_of(b) - value_of(a));
}

double dissipated_of(const Sample& s) { return s.dissipated; }
double load_of(const Sample& s) { return s.load; }
double displacement_of(const Sample& s) { return s.displacement; }

/// Accepted states of a path up to the dissipated energy `end`.
Samples states(const Trace& trace, double end) {
  Samples out;
  for (const TracePoint& at : trace)
    if (at.dissipated <= end) out.push_back({at.dissipated, displacement(at), at.load});
  return out;
}

/// The samples up to where dissipation begins.
Samples elastic_part(const Samples& path) {
  constexpr double round_off = 1e-12;
  const double start = path.front().dissipated, whole = path.back().dissipated - start;
  const auto end =
      std::ranges::find_if(path, [&](const Sample& s) { return s.dissipated - start > round_off * whole; });
  return {path.begin(), end};
}

/// A path between its steps, both ways: a state lies on it when it lies on either.
struct Interpolated {
  Samples smooth, kinked;
  Interpolated(const Trace& trace, double end)
      : smooth(samples(trace, end, Between::hermite)), kinked(samples(trace, end, Between::tangents)) {}
};

/// How far accepted states lie from an interpolated path.
double largest_difference(const Interpolated& path, const Samples& states, const Sample& peak) {
  const Samples elastic = elastic_part(path.smooth), elastic_states = elastic_part(states);
  double out = 0;
  if (peak.displacement != 0 && std::ranges::is_sorted(elastic, {}, load_of))
    for (const Sample& s : elastic_states)
      if (s.load <= elastic.back().load)
        out = std::max(out, std::abs((s.displacement - lookup(elastic, s.load, load_of, displacement_of)) /
                                     peak.displacement));
  const auto gap = [&](const Samples& way, const Sample& at) {
    return std::abs((at.load - lookup(way, at.dissipated, dissipated_of, load_of)) / peak.load);
  };
  for (std::size_t i = elastic_states.size(); i < states.size(); ++i)
    out = std::max(out, std::min(gap(path.smooth, states[i]), gap(path.kinked, states[i])));
  return out;
}

double squared_distance(const Sample& x, const Sample& a, const Sample& b, const Sample& unit) {
  const Vec2 scale(unit.displacement != 0 ? 1 / unit.displacement : 0, 1 / unit.load);
  const auto place = [&](const Sample& s) -> Vec2 {
    return Vec2(s.displacement, s.load).cwiseProduct(scale);
  };
  const Vec2 along = place(b) - place(a), from = place(x) - place(a);
  const double length = along.squaredNorm();
  const double s = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0.0;
  return (from - s * along).squaredNorm();
}

double nearest(const Sample& x, const Samples& to, const Sample& peak) {
  double out = squared_distance(x, to[0], to[0], peak);
  for (std::size_t i = 0; i + 1 < to.size(); ++i)
    out = std::min(out, squared_distance(x, to[i], to[i + 1], peak));
  return std::sqrt(out);
}

/// The farthest that one of the states lies from the path.
double one_sided(const Samples& states, const Interpolated& path, const Sample& peak) {
  double out = 0;
  for (const Sample& x : states)
    out = std::max(out, std::min(nearest(x, path.smooth, peak), nearest(x, path.kinked, peak)));
  return out;
}

}  // namespace

PathDistance distance(const Trace& first, const Trace& second) {
  const double end = std::min(first.back().dissipated, second.back().dissipated);
  const auto top =
      std::ranges::max_element(first, {}, [](const TracePoint& at) { return std::abs(at.load); });
  const Sample peak{top->dissipated, displacement(*top), top->load};
  if (peak.load == 0) return {};
  const Interpolated a(first, end), b(second, end);
  const Samples of_first = states(first, end), of_second = states(second, end);
  return {std::max(largest_difference(a, of_second, peak), largest_difference(b, of_first, peak)),
          std::max(one_sided(of_second, a, peak), one_sided(of_first, b, peak))};
}

double difference_at(const Trace& first, const Trace& second, std::size_t k,
                     const std::vector<double>& values) {
  const auto landed = [&](const Trace& trace, double value) {
    constexpr double round_off = 1e-7;
    return std::ranges::find_if(trace, [&](const TracePoint& at) {
      return std::abs(at.displacements[k] - value) <= round_off * std::abs(value);
    });
  };
  double largest = std::numeric_limits<double>::quiet_NaN();
  for (const double value : values) {
    const auto a = landed(first, value), b = landed(second, value);
    if (a != first.end() && b != second.end()) largest = std::fmax(largest, std::abs(a->load - b->load));
  }
  return largest / std::ranges::max(first, {}, &TracePoint::load).load;
}

}  // namespace dda
