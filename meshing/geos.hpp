#pragma once

#include <memory>
#include <vector>

#include "meshing/polygon.hpp"

namespace dda {

double area(const Figure& figure);

/// Area common to two figures [L²].
double common_area(const Figure& a, const Figure& b);

/// The pieces into which the polylines cut a figure; a line that ends inside cuts nothing.
std::vector<Figure> cut(const Figure& figure, const std::vector<std::vector<Vec2>>& lines);

/// The closest-point cells of the sites, cells of the outer ones reaching far beyond `box`. In no special
/// order.
std::vector<Polygon> voronoi_cells(const std::vector<Vec2>& sites, const Box& box);

/// A point in the interior of a polygon, near its middle.
Vec2 point_inside(const Polygon& polygon);

/// Clips many polygons by one figure, for one thread.
class Clipper {
 public:
  explicit Clipper(const Figure& figure);
  ~Clipper();
  Clipper(const Clipper&) = delete;
  Clipper& operator=(const Clipper&) = delete;

  /// What of the polygon lies in the figure: none, one or several pieces.
  std::vector<Figure> clip(const Polygon& polygon) const;
  bool holds(const Vec2& x) const;
  const Figure& figure() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace dda
