#pragma once

#include <memory>
#include <stdexcept>
#include <vector>

#include "meshing/geometry/polygon.hpp"

namespace dda {

/// GEOS did not do what it was asked, for polygons of no area or of numbers too far apart.
class GeosError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

double area(const Figure& figure);

/// Area common to two figures [L²].
double common_area(const Figure& a, const Figure& b);

/// Area of the convex hull of some points [L²].
double hull_area(const std::vector<Vec2>& points);

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
  static std::unique_ptr<const Clipper> of(const Figure& figure);

  Clipper() = default;
  virtual ~Clipper() = default;
  Clipper(const Clipper&) = delete;
  Clipper& operator=(const Clipper&) = delete;

  /// What of the polygon lies in the figure: none, one or several pieces.
  virtual std::vector<Figure> clip(const Polygon& polygon) const = 0;
  virtual bool holds(const Vec2& x) const = 0;
  virtual const Figure& figure() const = 0;
};

/// What the GEOS module gives out under the symbol `dda_geos_module`. It is loaded with the first question: a
/// scene of triangles, grids or convex polygons has none, and GEOS makes the start of a process 5 ms longer.
struct GeosModule {
  double (*common_area)(const Figure&, const Figure&);
  double (*hull_area)(const std::vector<Vec2>&);
  std::vector<Figure> (*cut)(const Figure&, const std::vector<std::vector<Vec2>>&);
  std::vector<Polygon> (*voronoi_cells)(const std::vector<Vec2>&, const Box&);
  Vec2 (*point_inside)(const Polygon&);
  std::unique_ptr<const Clipper> (*clipper)(const Figure&);
};

}  // namespace dda
