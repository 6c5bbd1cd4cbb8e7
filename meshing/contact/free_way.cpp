#include "meshing/contact/free_way.hpp"

#include <algorithm>
#include <cmath>

#include "meshing/geometry/polygon.hpp"

namespace dda {
namespace {

/// A vertex and an edge, each with its motion.
struct VertexAndEdge {
  Vec2 x, v, start, start_v, end, end_v;

  double distance_at(double a) const { return distance(x + a * v, start + a * start_v, end + a * end_v); }
  /// By how much the distance can shrink per unit of a.
  double rate() const { return std::max((v - start_v).norm(), (v - end_v).norm()); }
};

double way_of(const VertexAndEdge& pair, double kept, double most) {
  constexpr int enough = 50;
  constexpr double near = 1e-3;  // of the distance that may go
  const double now = pair.distance_at(0), rate = pair.rate();
  double may_go = (1 - kept) * now, a = 0;
  if (rate * most <= may_go) return most;
  for (int i = 0; i < enough; ++i) {
    a += may_go / rate;
    if (a >= most) return most;
    may_go = pair.distance_at(a) - kept * now;
    if (may_go <= near * now) break;
  }
  return a;
}

bool are_far(const Vec2& x, const Vec2& start, const Vec2& end, double far) {
  const Vec2 edge = end - start, to = x - start;
  const double share = std::clamp(to.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (to - share * edge).squaredNorm() > far * far;
}

double fastest(const MovingOutline& outline) {
  double out = 0;
  for (const Vec2& v : outline.v) out = std::max(out, v.squaredNorm());
  return std::sqrt(out);
}

/// Vertices and edges so far from each other that no motion of both could bring them near are passed by.
double ways_of(const MovingOutline& vertices, const MovingOutline& edges, double kept, double most) {
  const std::size_t n = edges.x.size();
  const double far = most * (fastest(vertices) + fastest(edges)) / (1 - kept);
  Vec2 low = edges.x.front(), high = low;
  for (const Vec2& x : edges.x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  low.array() -= far;
  high.array() += far;
  for (std::size_t i = 0; i < vertices.x.size(); ++i) {
    const Vec2& x = vertices.x[i];
    if ((x.array() < low.array()).any() || (x.array() > high.array()).any()) continue;
    for (std::size_t e = 0; e < n; ++e) {
      const std::size_t f = e + 1 == n ? 0 : e + 1;
      if (are_far(x, edges.x[e], edges.x[f], far)) continue;
      most =
          way_of({vertices.x[i], vertices.v[i], edges.x[e], edges.v[e], edges.x[f], edges.v[f]}, kept, most);
    }
  }
  return most;
}

}  // namespace

double free_way(const MovingOutline& one, const MovingOutline& other, double kept, double most) {
  return ways_of(other, one, kept, ways_of(one, other, kept, most));
}

}  // namespace dda
