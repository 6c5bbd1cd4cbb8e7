#include "meshing/geometry/geos.hpp"

#include "framework/base/loaded.hpp"

namespace dda {
namespace {

const GeosModule& module() {
  static const auto* loaded =
      static_cast<const GeosModule*>(symbol_of(module_file("dda_geos.so"), "dda_geos_module"));
  return *loaded;
}

}  // namespace

double area(const Figure& figure) {
  double sum = signed_area(figure.outline);
  for (const Polygon& hole : figure.holes) sum -= std::abs(signed_area(hole));
  return sum;
}

double common_area(const Figure& a, const Figure& b) { return module().common_area(a, b); }

double hull_area(const std::vector<Vec2>& points) { return module().hull_area(points); }

std::vector<Figure> cut(const Figure& figure, const std::vector<std::vector<Vec2>>& lines) {
  return lines.empty() ? std::vector{figure} : module().cut(figure, lines);
}

std::vector<Polygon> voronoi_cells(const std::vector<Vec2>& sites, const Box& box) {
  return module().voronoi_cells(sites, box);
}

Vec2 point_inside(const Polygon& polygon) { return module().point_inside(polygon); }

std::unique_ptr<const Clipper> Clipper::of(const Figure& figure) { return module().clipper(figure); }

}  // namespace dda
