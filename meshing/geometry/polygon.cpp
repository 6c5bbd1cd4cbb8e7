#include "meshing/geometry/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dda {

void Box::include(const Vec2& x) {
  low = low.cwiseMin(x);
  high = high.cwiseMax(x);
}

Box Box::inflated(double margin) const {
  return {low - Vec2::Constant(margin), high + Vec2::Constant(margin)};
}

bool Box::touches(const Box& other) const {
  return low.x() <= other.high.x() && other.low.x() <= high.x() && low.y() <= other.high.y() &&
         other.low.y() <= high.y();
}

bool Box::contains(const Vec2& x) const { return touches({x, x}); }

Box bounding_box(const std::vector<Vec2>& points) {
  Box box;
  for (const Vec2& x : points) box.include(x);
  return box;
}

double signed_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(polygon.at(i) - polygon.at(0), polygon.at(i + 1) - polygon.at(0));
  return twice / 2;
}

Moments moments(const Polygon& polygon) {
  double area = 0;
  Vec2 first = Vec2::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon.at(i) - polygon.at(0), b = polygon.at(i + 1) - polygon.at(0);
    const double piece = cross(a, b) / 2;
    const Vec2 sum = a + b;
    area += piece;
    first += piece / 3 * sum;
    second += piece / 12 * (a * a.transpose() + b * b.transpose() + sum * sum.transpose());
  }
  const Vec2 centre = area != 0 ? Vec2(first / area) : Vec2::Zero();
  return {area, polygon.at(0) + centre, second - area * centre * centre.transpose()};
}

double perimeter(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += (polygon.at(i + 1) - polygon.at(i)).norm();
  return sum;
}

Polygon counter_clockwise(Polygon polygon) {
  if (signed_area(polygon) < 0) std::reverse(polygon.vertices.begin(), polygon.vertices.end());
  return polygon;
}

Polygon without_collinear(const Polygon& polygon, double tolerance) {
  Polygon distinct, result;
  for (const Vec2& x : polygon.vertices)
    if (distinct.vertices.empty() || (x - distinct.vertices.back()).norm() > tolerance)
      distinct.vertices.push_back(x);
  while (distinct.size() > 1 && (distinct.vertices.front() - distinct.vertices.back()).norm() <= tolerance)
    distinct.vertices.pop_back();
  for (std::size_t i = 0, n = distinct.size(); i < n; ++i) {
    const Vec2& before = result.size() ? result.vertices.back() : distinct.at(n - 1);
    if (distance(distinct.at(i), before, distinct.at(i + 1)) > tolerance)
      result.vertices.push_back(distinct.at(i));
  }
  return result;
}

bool is_convex(const Polygon& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 in = polygon.at(i + 1) - polygon.at(i), out = polygon.at(i + 2) - polygon.at(i + 1);
    // A vertex on the middle of a side is no reentrant corner, however it is rounded.
    if (cross(in, out) < -1e-9 * in.norm() * out.norm()) return false;
  }
  return true;
}

double distance(const Vec2& x, const Vec2& start, const Vec2& end) {
  const Vec2 along = end - start;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((x - start).dot(along) / square, 0.0, 1.0) : 0.0;
  return (x - start - t * along).norm();
}

namespace {

bool on_outline(const Polygon& polygon, const Vec2& x, double tolerance) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if (distance(x, polygon.at(i), polygon.at(i + 1)) <= tolerance) return true;
  return false;
}

/// Even-odd rule on the half-open ray to the right of x.
bool inside(const Polygon& polygon, const Vec2& x) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon.at(i), &b = polygon.at(i + 1);
    if ((a.y() > x.y()) == (b.y() > x.y())) continue;
    if (x.x() < a.x() + (x.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) odd = !odd;
  }
  return odd;
}

std::string text(const Vec2& x) { return fmt::format("({:.6g}, {:.6g})", x.x(), x.y()); }

struct Segment {
  Vec2 from, to;
};

/// Do the closed segments ab and cd come closer than `tolerance`?
bool meet(const Segment& one, const Segment& other, double tolerance) {
  const auto& [a, b] = one;
  const auto& [c, d] = other;
  const double end = std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
  if (end <= tolerance) return true;
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

/// Does the outline fold back on itself at vertex i + 1?
bool has_spike(const Polygon& polygon, std::size_t i, double tolerance) {
  return distance(polygon.at(i), polygon.at(i + 1), polygon.at(i + 2)) <= tolerance ||
         distance(polygon.at(i + 2), polygon.at(i), polygon.at(i + 1)) <= tolerance;
}

std::optional<std::string> crossing(const Polygon& polygon, double tolerance) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (has_spike(polygon, i, tolerance)) return "crosses itself near " + text(polygon.at(i + 1));
    for (std::size_t j = i + 2; j < n; ++j)
      if (!(i == 0 && j == n - 1) &&
          meet({polygon.at(i), polygon.at(i + 1)}, {polygon.at(j), polygon.at(j + 1)}, tolerance))
        return "crosses itself near " + text(polygon.at(j));
  }
  return {};
}

std::optional<std::string> repetition(const Polygon& polygon, double tolerance) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (std::size_t j = i + 1; j < polygon.size(); ++j)
      if ((polygon.at(i) - polygon.at(j)).norm() <= tolerance)
        return "repeats the vertex " + text(polygon.at(i));
  return {};
}

/// Largest of |cross(vᵢ − v₀, vᵢ₊₁ − v₀)| [L²]: zero only when all vertices are on one line.
double widest_fan(const Polygon& polygon) {
  double most = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    most = std::max(most, std::abs(cross(polygon.at(i) - polygon.at(0), polygon.at(i + 1) - polygon.at(0))));
  return most;
}

}  // namespace

bool contains(const Polygon& polygon, const Vec2& x, double tolerance) {
  return inside(polygon, x) || on_outline(polygon, x, tolerance);
}

std::optional<std::string> defect(const Polygon& polygon) {
  if (polygon.size() < 3) return "has fewer than three vertices";
  const double size = bounding_box(polygon.vertices).size(), tolerance = 1e-9 * size;
  if (const auto twice = repetition(polygon, tolerance)) return twice;
  if (!(widest_fan(polygon) > tolerance * size)) return "has zero area";
  return crossing(polygon, tolerance);
}

Polygon left_part(const Polygon& convex, const Vec2& a, const Vec2& b) {
  Polygon result;
  for (std::size_t i = 0; i < convex.size(); ++i) {
    const Vec2 &p = convex.at(i), &q = convex.at(i + 1);
    const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
    if (at_p >= 0) result.vertices.push_back(p);
    if ((at_p < 0) != (at_q < 0) && at_p != 0 && at_q != 0)
      result.vertices.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return result;
}

Eigen::Matrix2d axes_along(const Polygon& polygon) {
  const Vec2 along = (polygon.at(1) - polygon.at(0)).normalized();
  Eigen::Matrix2d axes;
  axes << along, Vec2(-along.y(), along.x());
  return axes;
}

double convex_overlap(const Polygon& a, const Polygon& b) {
  Polygon rest = a;
  for (std::size_t i = 0; i < b.size() && rest.size() > 2; ++i) rest = left_part(rest, b.at(i), b.at(i + 1));
  return rest.size() > 2 ? signed_area(rest) : 0;
}

}  // namespace dda
