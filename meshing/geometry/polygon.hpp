#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda {

/// A simple polygon, vertices counter-clockwise, not closed (first vertex not repeated). May be non-convex.
struct Polygon {
  std::vector<Vec2> vertices;

  std::size_t size() const { return vertices.size(); }
  /// Vertex i, counted cyclically.
  const Vec2& at(std::size_t i) const { return vertices[i % vertices.size()]; }
};

/// A plane figure in one piece: its outline, counter-clockwise, and the holes in it.
struct Figure {
  Polygon outline;
  std::vector<Polygon> holes;
};

/// Exact integrals over a polygon: area [L²], centroid [L], second = ∫ (x−c)(x−c)ᵀ dA [L⁴], 2 × 2.
struct Moments {
  double area = 0;
  Vec2 centroid = Vec2::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
};

/// An axis-parallel box, closed.
struct Box {
  Vec2 low = Vec2::Constant(1e300);
  Vec2 high = Vec2::Constant(-1e300);

  void include(const Vec2& x);
  Box inflated(double margin) const;
  bool touches(const Box& other) const;
  bool contains(const Vec2& x) const;
  Vec2 centre() const { return (low + high) / 2; }
  /// Larger of the two extents [L].
  double size() const { return (high - low).maxCoeff(); }
};

Box bounding_box(const std::vector<Vec2>& points);

/// Area, positive when the vertices run counter-clockwise [L²].
double signed_area(const Polygon& polygon);

/// Integrals over the polygon, as a sum over the simplices (v₀, vᵢ, vᵢ₊₁); signed with the orientation.
///
///     ∫ x xᵀ dA = A/12 (Σ a aᵀ + s sᵀ),   s = Σ a over the three corners of a triangle
///
/// Coordinates are taken relative to v₀, so that a translation costs no digits.
Moments moments(const Polygon& polygon);

double perimeter(const Polygon& polygon);

/// The same outline, counter-clockwise.
Polygon counter_clockwise(Polygon polygon);

/// The same outline without vertices that lie within `tolerance` [L] of the line of their neighbours or of
/// the vertex before them.
Polygon without_collinear(const Polygon& polygon, double tolerance);

bool is_convex(const Polygon& polygon);

/// Distance from x to the segment from `start` to `end` [L].
double distance(const Vec2& x, const Vec2& start, const Vec2& end);

/// Is x inside, on the outline, or within `tolerance` [L] of it?
bool contains(const Polygon& polygon, const Vec2& x, double tolerance);

/// What keeps the outline from being that of a simple polygon ("crosses itself near (1, 2)"), or nothing.
std::optional<std::string> defect(const Polygon& polygon);

/// Unit vectors along the polygon's first side and square to it, as columns.
Eigen::Matrix2d axes_along(const Polygon& polygon);

/// Area common to two convex polygons [L²].
double convex_overlap(const Polygon& a, const Polygon& b);

/// The part of a convex polygon that lies left of the directed line through a and b; may be empty.
Polygon left_part(const Polygon& convex, const Vec2& a, const Vec2& b);

}  // namespace dda
