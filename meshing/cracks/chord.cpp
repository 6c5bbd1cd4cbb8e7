#include "meshing/cracks/chord.hpp"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace dda {
namespace {

/// A place on the outline: on an edge, or at the vertex where that edge starts.
struct Place {
  std::size_t edge = 0;
  bool at_vertex = false;
};

std::optional<Place> place_on(const Polygon& polygon, const Vec2& x, double tolerance) {
  for (std::size_t i = 0; i < polygon.size(); ++i)
    if ((x - polygon.at(i)).norm() <= tolerance) return Place{i, true};
  double nearest = tolerance;
  std::optional<Place> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const double off = distance(x, polygon.at(i), polygon.at(i + 1));
    if (off > nearest) continue;
    nearest = off;
    out = Place{i, false};
  }
  return out;
}

/// Angle by which `to` lies counter-clockwise of `from`, in [0, 2π).
double turn(const Vec2& from, const Vec2& to) {
  const double angle = std::atan2(cross(from, to), from.dot(to));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

/// The outline from one place to another, counter-clockwise.
Polygon stretch(const Polygon& polygon, std::pair<Place, Vec2> from, std::pair<Place, Vec2> to) {
  Polygon out{{from.second}};
  const std::size_t n = polygon.size();
  const std::size_t stop = (to.first.at_vertex ? to.first.edge : to.first.edge + 1) % n;
  for (std::size_t k = (from.first.edge + 1) % n; k != stop; k = (k + 1) % n)
    out.vertices.push_back(polygon.at(k));
  out.vertices.push_back(to.second);
  return out;
}

}  // namespace

bool enters(const Polygon& polygon, const Vec2& from, const Vec2& direction, double tolerance) {
  const auto place = place_on(polygon, from, tolerance);
  if (!place) return false;
  const Vec2 out = polygon.at(place->edge + 1) - polygon.at(place->edge);
  if (!place->at_vertex) return cross(out, direction) > 0;
  const Vec2 back = polygon.at(place->edge + polygon.size() - 1) - polygon.at(place->edge);
  const double angle = turn(out, direction);
  return angle > 0 && angle < turn(out, back);
}

std::optional<Vec2> exit_of(const Polygon& polygon, const Vec2& from, const Vec2& direction,
                            double tolerance) {
  const Vec2 along = direction.normalized();
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<Vec2> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon.at(i), &b = polygon.at(i + 1);
    const Vec2 edge = b - a;
    const double across = cross(along, edge), length = edge.norm();
    if (std::abs(across) <= std::numeric_limits<double>::epsilon() * length) continue;
    const double way = cross(a - from, edge) / across, share = cross(a - from, along) / across;
    if (way <= tolerance || way >= nearest) continue;
    if (share * length < -tolerance || (share - 1) * length > tolerance) continue;
    nearest = way;
    out = share * length <= tolerance ? a : (1 - share) * length <= tolerance ? b : Vec2(a + share * edge);
  }
  return out;
}

std::array<Polygon, 2> divided(const Polygon& polygon, const Vec2& start, const Vec2& end, double tolerance) {
  const auto from = place_on(polygon, start, tolerance), to = place_on(polygon, end, tolerance);
  assert(from && to);
  const Vec2 p = from->at_vertex ? polygon.at(from->edge) : start,
             q = to->at_vertex ? polygon.at(to->edge) : end;
  return {stretch(polygon, {*to, q}, {*from, p}), stretch(polygon, {*from, p}, {*to, q})};
}

double distance(const Vec2& x, const Polygon& polygon) {
  if (contains(polygon, x, 0)) return 0;
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    out = std::min(out, distance(x, polygon.at(i), polygon.at(i + 1)));
  return out;
}

}  // namespace dda
