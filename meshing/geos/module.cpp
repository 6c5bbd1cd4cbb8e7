#include <geos_c.h>

#include <stdexcept>

#include "meshing/geometry/geos.hpp"

namespace dda {
namespace {

/// GEOS' context of this thread; its messages go nowhere, failures come back as null pointers.
GEOSContextHandle_t context() {
  struct Owner {
    GEOSContextHandle_t handle = GEOS_init_r();
    ~Owner() { GEOS_finish_r(handle); }
  };
  thread_local const Owner owner;
  return owner.handle;
}

struct Destroy {
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context(), g); }
  void operator()(const GEOSPreparedGeometry* g) const { GEOSPreparedGeom_destroy_r(context(), g); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;
using Prepared = std::unique_ptr<const GEOSPreparedGeometry, Destroy>;

Geometry own(GEOSGeometry* g) {
  if (!g) throw GeosError("GEOS could not process a polygon");
  return Geometry(g);
}

GEOSCoordSequence* sequence(const std::vector<Vec2>& points, bool closed) {
  const auto n = static_cast<unsigned>(points.size());
  GEOSCoordSequence* s = GEOSCoordSeq_create_r(context(), n + (closed ? 1 : 0), 2);
  for (unsigned i = 0; i < n; ++i) GEOSCoordSeq_setXY_r(context(), s, i, points[i].x(), points[i].y());
  if (closed) GEOSCoordSeq_setXY_r(context(), s, n, points[0].x(), points[0].y());
  return s;
}

GEOSGeometry* ring(const Polygon& polygon) {
  return GEOSGeom_createLinearRing_r(context(), sequence(polygon.vertices, true));
}

Geometry geometry(const Figure& figure) {
  std::vector<GEOSGeometry*> holes;
  for (const Polygon& hole : figure.holes) holes.push_back(ring(hole));
  return own(GEOSGeom_createPolygon_r(context(), ring(figure.outline), holes.data(),
                                      static_cast<unsigned>(holes.size())));
}

Geometry line(const std::vector<Vec2>& points) {
  return own(GEOSGeom_createLineString_r(context(), sequence(points, false)));
}

Geometry collect(int type, std::vector<Geometry> parts) {
  std::vector<GEOSGeometry*> raw;
  for (Geometry& part : parts) raw.push_back(part.release());
  return own(GEOSGeom_createCollection_r(context(), type, raw.data(), static_cast<unsigned>(raw.size())));
}

Polygon polygon_of(const GEOSGeometry* closed_ring) {
  const GEOSCoordSequence* s = GEOSGeom_getCoordSeq_r(context(), closed_ring);
  unsigned n = 0;
  GEOSCoordSeq_getSize_r(context(), s, &n);
  Polygon polygon;
  for (unsigned i = 0; i + 1 < n; ++i) {
    Vec2 x;
    GEOSCoordSeq_getXY_r(context(), s, i, &x.x(), &x.y());
    polygon.vertices.push_back(x);
  }
  return counter_clockwise(polygon);
}

Figure figure_of(const GEOSGeometry* g) {
  Figure figure{polygon_of(GEOSGetExteriorRing_r(context(), g)), {}};
  for (int i = 0; i < GEOSGetNumInteriorRings_r(context(), g); ++i)
    figure.holes.push_back(polygon_of(GEOSGetInteriorRingN_r(context(), g, i)));
  return figure;
}

/// The polygons in a geometry; points and lines, left where figures only touch, are dropped.
std::vector<Figure> figures_of(const GEOSGeometry* g) {
  std::vector<Figure> figures;
  for (int i = 0; i < GEOSGetNumGeometries_r(context(), g); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(context(), g, i);
    if (GEOSGeomTypeId_r(context(), part) == GEOS_POLYGON && !GEOSisEmpty_r(context(), part))
      figures.push_back(figure_of(part));
  }
  return figures;
}

Geometry point(const Vec2& x) { return own(GEOSGeom_createPointFromXY_r(context(), x.x(), x.y())); }

/// Eight sites so far out that they are nowhere in the box the nearest; they bound the cells of the others.
std::vector<Geometry> far_sites(const Box& box) {
  const double far = 8 * box.size();
  std::vector<Geometry> sites;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      if (i != 0 || j != 0) sites.push_back(point(box.centre() + far * Vec2(i, j)));
  return sites;
}

}  // namespace

namespace geos {

double common_area(const Figure& a, const Figure& b) {
  const Geometry common = own(GEOSIntersection_r(context(), geometry(a).get(), geometry(b).get()));
  double result = 0;
  GEOSArea_r(context(), common.get(), &result);
  return result;
}

double hull_area(const std::vector<Vec2>& points) {
  const Geometry hull = own(GEOSConvexHull_r(context(), line(points).get()));
  double result = 0;
  GEOSArea_r(context(), hull.get(), &result);
  return result;
}

std::vector<Figure> cut(const Figure& figure, const std::vector<std::vector<Vec2>>& lines) {
  const Geometry whole = geometry(figure);
  std::vector<Geometry> drawn;
  drawn.push_back(own(GEOSBoundary_r(context(), whole.get())));
  for (const auto& points : lines) drawn.push_back(line(points));
  const Geometry noded =
      own(GEOSUnaryUnion_r(context(), collect(GEOS_GEOMETRYCOLLECTION, std::move(drawn)).get()));
  const GEOSGeometry* input = noded.get();
  const Geometry faces = own(GEOSPolygonize_r(context(), &input, 1));
  std::vector<Figure> pieces;
  for (Figure& face : figures_of(faces.get())) {
    const Geometry middle = own(GEOSPointOnSurface_r(context(), geometry(face).get()));
    if (GEOSContains_r(context(), whole.get(), middle.get()) == 1) pieces.push_back(std::move(face));
  }
  return pieces;
}

std::vector<Polygon> voronoi_cells(const std::vector<Vec2>& sites, const Box& box) {
  std::vector<Geometry> points = far_sites(box);
  for (const Vec2& x : sites) points.push_back(point(x));
  const Geometry all = collect(GEOS_MULTIPOINT, std::move(points));
  const Geometry cells = own(GEOSVoronoiDiagram_r(context(), all.get(), nullptr, 0, 0));
  std::vector<Polygon> result;
  for (Figure& cell : figures_of(cells.get()))
    if (bounding_box(cell.outline.vertices).touches(box)) result.push_back(std::move(cell.outline));
  return result;
}

Vec2 point_inside(const Polygon& polygon) {
  const Geometry inside = own(GEOSPointOnSurface_r(context(), geometry({polygon, {}}).get()));
  Vec2 x;
  GEOSGeomGetX_r(context(), inside.get(), &x.x());
  GEOSGeomGetY_r(context(), inside.get(), &x.y());
  return x;
}

class PreparedClipper final : public Clipper {
 public:
  explicit PreparedClipper(const Figure& figure)
      : figure_(figure),
        is_convex_(figure.holes.empty() && is_convex(figure.outline)),
        whole_(geometry(figure)),
        prepared_(GEOSPrepare_r(context(), whole_.get())) {}

  std::vector<Figure> clip(const Polygon& polygon) const override {
    const Polygon& outline = figure_.outline;
    if (is_convex_ && is_convex(polygon)) {
      Polygon rest = polygon;
      for (std::size_t i = 0; i < outline.size() && rest.size() > 2; ++i)
        rest = left_part(rest, outline.at(i), outline.at(i + 1));
      return rest.size() > 2 ? std::vector<Figure>{{rest, {}}} : std::vector<Figure>{};
    }
    const Geometry cell = geometry({polygon, {}});
    if (GEOSPreparedContains_r(context(), prepared_.get(), cell.get()) == 1) return {{polygon, {}}};
    return figures_of(own(GEOSIntersection_r(context(), whole_.get(), cell.get())).get());
  }

  bool holds(const Vec2& x) const override {
    return GEOSPreparedContains_r(context(), prepared_.get(), point(x).get()) == 1;
  }
  const Figure& figure() const override { return figure_; }

 private:
  Figure figure_;
  bool is_convex_;
  Geometry whole_;
  Prepared prepared_;
};

std::unique_ptr<const Clipper> clipper(const Figure& figure) {
  return std::make_unique<PreparedClipper>(figure);
}

}  // namespace geos
}  // namespace dda

/// The module's one symbol, looked up by name in meshing/geos.cpp.
extern "C" const dda::GeosModule dda_geos_module;
const dda::GeosModule dda_geos_module{&dda::geos::common_area,  &dda::geos::hull_area,
                                      &dda::geos::cut,          &dda::geos::voronoi_cells,
                                      &dda::geos::point_inside, &dda::geos::clipper};
