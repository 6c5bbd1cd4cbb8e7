#include "meshing/geometry/voronoi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "framework/base/disjoint_sets.hpp"
#include "framework/base/threads.hpp"
#include "meshing/geometry/box_grid.hpp"

namespace dda {
namespace {

constexpr double shortest_edge = 1e-6;  // of the mean cell size

/// Uniform in [0, 1) from the upper 53 bits; the standard's distributions differ between libraries.
double uniform(std::mt19937_64& bits) { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

std::vector<Vec2> random_sites(const Clipper& region, const Box& box, const VoronoiWish& wish) {
  std::mt19937_64 bits(wish.seed);
  std::vector<Vec2> sites;
  constexpr int most_misses = 1'000'000;  // in a row; the region has no area to speak of
  for (int misses = 0; sites.size() < wish.blocks; ++misses) {
    if (misses == most_misses)
      throw GeosError(fmt::format("a part around ({:.6g}, {:.6g}) has no room for a cell", box.centre().x(),
                                  box.centre().y()));
    const double x = uniform(bits), y = uniform(bits);
    const Vec2 site = box.low + (box.high - box.low).cwiseProduct(Vec2(x, y));
    if (!region.holds(site)) continue;
    sites.push_back(site);
    misses = 0;
  }
  return sites;
}

/// A cell of one site inside the region, in as many pieces as the outline leaves of it.
using Pieces = std::vector<Figure>;

/// visit(i, region) for each i below a number; GEOS prepares a region for one thread.
template <class Visit>
void for_each_cell(std::size_t count, const Clipper& region, Visit&& visit) {
  constexpr std::size_t cells_at_once = 500;
  parallel_pieces(count, cells_at_once, [&](std::size_t begin, std::size_t end) {
    const auto own = Clipper::of(region.figure());
    for (std::size_t i = begin; i < end; ++i) visit(i, *own);
  });
}

std::vector<Pieces> clipped(const std::vector<Polygon>& cells, const Clipper& region) {
  std::vector<Pieces> result(cells.size());
  for_each_cell(cells.size(), region,
                [&](std::size_t i, const Clipper& own) { result[i] = own.clip(cells[i]); });
  std::erase_if(result, [](const Pieces& pieces) { return pieces.empty(); });
  return result;
}

/// Where Lloyd moves a site: the centroid of the largest piece, or a point in it where that lies outside.
Vec2 next_site(const Pieces& pieces, const Clipper& region) {
  const auto smaller = [](const Figure& a, const Figure& b) { return area(a) < area(b); };
  const Figure& largest = *std::max_element(pieces.begin(), pieces.end(), smaller);
  const Vec2 centroid = moments(largest.outline).centroid;
  return region.holds(centroid) ? centroid : point_inside(largest.outline);
}

bool by_place(const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); }

std::vector<Vec2> relaxed(const std::vector<Vec2>& sites, const Clipper& region, const Box& box) {
  const std::vector<Pieces> cells = clipped(voronoi_cells(sites, box), region);
  std::vector<Vec2> next(cells.size());
  for_each_cell(cells.size(), region,
                [&](std::size_t i, const Clipper& own) { next[i] = next_site(cells[i], own); });
  // The library's order of cells is not promised; a sorted one makes the next round repeatable.
  std::sort(next.begin(), next.end(), by_place);
  return next;
}

/// A piece around a hole is cut through the hole's middle until no hole is left.
void add_without_holes(const Figure& piece, std::vector<Polygon>& cells) {
  if (piece.holes.empty()) return cells.push_back(piece.outline);
  const Box box = bounding_box(piece.outline.vertices);
  const double far = 2 * box.size(), x = moments(piece.holes[0]).centroid.x();
  const Vec2 low = box.centre() - Vec2(0, far), high = box.centre() + Vec2(0, far);
  for (const Figure& part : cut(piece, {{Vec2(x, low.y()), Vec2(x, high.y())}}))
    add_without_holes(part, cells);
}

double distance_to(const Polygon& polygon, const Vec2& x) {
  double least = distance(x, polygon.at(0), polygon.at(1));
  for (std::size_t i = 1; i < polygon.size(); ++i)
    least = std::min(least, distance(x, polygon.at(i), polygon.at(i + 1)));
  return least;
}

/// 0 at a corner of the figure, 1 on its outline, 2 inside: of two merged vertices the lower one stays in
/// place.
int rank(const Figure& figure, const Vec2& x, double tolerance) {
  std::vector<const Polygon*> rings{&figure.outline};
  for (const Polygon& hole : figure.holes) rings.push_back(&hole);
  int best = 2;
  for (const Polygon* ring : rings) {
    for (const Vec2& corner : ring->vertices)
      if ((x - corner).norm() <= tolerance) return 0;
    if (distance_to(*ring, x) <= tolerance) best = 1;
  }
  return best;
}

/// Vertices of all cells in one list, cell after cell.
std::vector<Vec2> all_vertices(const std::vector<Polygon>& cells) {
  std::vector<Vec2> all;
  for (const Polygon& cell : cells) all.insert(all.end(), cell.vertices.begin(), cell.vertices.end());
  return all;
}

/// Gives vertices that almost coincide one place.
std::vector<Vec2> merged(std::vector<Vec2> vertices, const Figure& figure, double tolerance) {
  std::vector<Box> boxes;
  for (const Vec2& x : vertices) boxes.push_back(Box{x, x}.inflated(tolerance / 2));
  DisjointSets sets(vertices.size());
  BoxGrid(std::move(boxes)).for_each_pair([&](std::size_t i, std::size_t j) {
    if (vertices[i] == vertices[j] || (vertices[i] - vertices[j]).norm() > tolerance) return;
    const std::size_t a = sets.representative(i), b = sets.representative(j);
    const bool keep_a =
        rank(figure, vertices[a], tolerance / 1000) <= rank(figure, vertices[b], tolerance / 1000);
    sets.merge_into(keep_a ? a : b, keep_a ? b : a);
  });
  std::vector<Vec2> result(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) result[i] = vertices[sets.representative(i)];
  return result;
}

std::vector<Polygon> without_short_edges(const std::vector<Polygon>& cells, const Figure& figure,
                                         double size) {
  const std::vector<Vec2> vertices = merged(all_vertices(cells), figure, shortest_edge * size);
  std::vector<Polygon> result;
  std::size_t next = 0;
  for (const Polygon& cell : cells) {
    const auto begin = vertices.begin() + static_cast<std::ptrdiff_t>(next);
    const Polygon moved{{begin, begin + static_cast<std::ptrdiff_t>(cell.size())}};
    next += cell.size();
    const Polygon clean = without_collinear(moved, 1e-9 * size);
    if (clean.size() > 2) result.push_back(clean);
  }
  return result;
}

void sort_by_centroid(std::vector<Polygon>& cells) {
  std::vector<std::pair<Vec2, Polygon>> placed;
  for (Polygon& cell : cells) placed.emplace_back(moments(cell).centroid, std::move(cell));
  std::sort(placed.begin(), placed.end(),
            [](const auto& a, const auto& b) { return by_place(a.first, b.first); });
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = std::move(placed[i].second);
}

std::vector<Polygon> cells_in(const Clipper& region, const std::vector<Polygon>& pattern, double size) {
  std::vector<Polygon> cells;
  for (const Pieces& pieces : clipped(pattern, region))
    for (const Figure& piece : pieces) add_without_holes(piece, cells);
  cells = without_short_edges(cells, region.figure(), size);
  sort_by_centroid(cells);
  return cells;
}

/// Of mean size `size`.
std::vector<Polygon> cells_of(const std::vector<Vec2>& sites, const Clipper& region, double size) {
  return cells_in(region, voronoi_cells(sites, bounding_box(region.figure().outline.vertices)), size);
}

/// Sites are off their places by a ten-millionth, since four cells that meet in a point exactly are more than the
/// library can tell apart; the short edges that this makes are taken out with all others.
std::vector<Vec2> lattice_sites(const Clipper& region, double size, double angle) {
  constexpr double off = 1e-7;
  std::mt19937_64 bits(1);
  const Box box = bounding_box(region.figure().outline.vertices);
  const Vec2 along(size * std::cos(angle), size * std::sin(angle)), across(-along.y(), along.x());
  const auto reach = static_cast<int>((box.high - box.low).norm() / 2 / size) + 1;
  std::vector<Vec2> sites;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      if (const Vec2 site =
              box.centre() + (i + off * uniform(bits)) * along + (j + off * uniform(bits)) * across;
          region.holds(site))
        sites.push_back(site);
  if (sites.empty()) sites.push_back(point_inside(region.figure().outline));
  return sites;
}

}  // namespace

std::vector<Polygon> centroidal_voronoi(const Figure& figure, const VoronoiWish& wish) {
  const std::unique_ptr<const Clipper> region = Clipper::of(figure);
  const Box box = bounding_box(figure.outline.vertices);
  std::vector<Vec2> sites = random_sites(*region, box, wish);
  for (int i = 0; i < wish.iterations; ++i) sites = relaxed(sites, *region, box);
  return cells_of(sites, *region, std::sqrt(area(figure) / static_cast<double>(wish.blocks)));
}

std::vector<Polygon> cells_in(const Figure& figure, const std::vector<Polygon>& pattern, double size) {
  return cells_in(*Clipper::of(figure), pattern, size);
}

std::vector<Polygon> square_cells(const Figure& figure, double size, double angle) {
  const std::unique_ptr<const Clipper> region = Clipper::of(figure);
  return cells_of(lattice_sites(*region, size, angle), *region, size);
}

std::vector<std::size_t> share(std::size_t count, const std::vector<double>& areas) {
  const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
  std::vector<std::size_t> shares;
  std::vector<std::pair<double, std::size_t>> remainders;
  std::size_t given = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double exact = static_cast<double>(count) * areas[i] / total;
    shares.push_back(std::max<std::size_t>(1, static_cast<std::size_t>(exact)));
    remainders.emplace_back(static_cast<double>(shares[i]) - exact, i);
    given += shares[i];
  }
  std::sort(remainders.begin(), remainders.end());
  for (std::size_t k = 0; k < remainders.size() && given < count; ++k, ++given)
    ++shares[remainders[k].second];
  return shares;
}

namespace {

/// Length of the segment ab inside a polygon, measured by its middle piece between crossings of the outline.
bool runs_through(const Polygon& cell, const Vec2& a, const Vec2& b) {
  const Box box = bounding_box(cell.vertices);
  if (!box.touches(bounding_box({a, b}))) return false;
  const double tolerance = shortest_edge * box.size(), length = (b - a).norm();
  std::vector<double> at{0, 1};
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const Vec2 edge = cell.at(i + 1) - cell.at(i);
    const double sine = cross(b - a, edge);
    if (sine != 0) at.push_back(std::clamp(cross(cell.at(i) - a, edge) / sine, 0.0, 1.0));
  }
  std::sort(at.begin(), at.end());
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Vec2 middle = a + (at[i] + at[i + 1]) / 2 * (b - a);
    if ((at[i + 1] - at[i]) * length > tolerance && contains(cell, middle, 0) &&
        distance_to(cell, middle) > tolerance)
      return true;
  }
  return false;
}

void add_halves(const Polygon& cell, const Vec2& a, const Vec2& b, std::vector<Polygon>& result) {
  const Vec2 reach = 4 * bounding_box(cell.vertices).size() * (b - a).normalized();
  const Vec2 foot = a + (moments(cell).centroid - a).dot(reach) / reach.squaredNorm() * reach;
  for (Figure& piece : cut({cell, {}}, {{Vec2(foot - reach), Vec2(foot + reach)}}))
    result.push_back(std::move(piece.outline));
}

}  // namespace

std::vector<Polygon> cut_cells(const std::vector<Polygon>& cells,
                               const std::vector<std::vector<Vec2>>& lines) {
  std::vector<Polygon> current = cells;
  for (const auto& line : lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      std::vector<Polygon> next;
      for (const Polygon& cell : current)
        if (runs_through(cell, line[i], line[i + 1]))
          add_halves(cell, line[i], line[i + 1], next);
        else
          next.push_back(cell);
      current = std::move(next);
    }
  return current;
}

}  // namespace dda
