#pragma once

#include <cstdint>
#include <vector>

#include "meshing/geometry/geos.hpp"

namespace dda {

/// How many cells, from which random sites, relaxed how often.
struct VoronoiWish {
  std::size_t blocks = 1;
  std::uint64_t seed = 1;
  int iterations = 20;  ///< of Lloyd: each site moves to the centroid of its cell
};

/// Centroidal Voronoi cells of a figure, also a non-convex one or one with holes, sorted by centroid (x, then
/// y).
///
/// Sites are drawn from mt19937_64 with a mapping of our own, so that a seed means the same on every machine.
/// A cell that the outline cuts into pieces gives a cell per piece, one around a hole two halves.
/// Vertices closer than 1e-6 of the mean cell size √(area/blocks) become one.
std::vector<Polygon> centroidal_voronoi(const Figure& figure, const VoronoiWish& wish);

/// Squares of a size in rows that are turned by an angle [rad], as cells of a lattice of sites: one site is the middle
/// of the figure's box. Beside the outline they are cut, and take in what is left of squares whose middle lies outside,
/// so that no cell is narrower than half a square but where the figure is. Sorted, and pieces and vertices treated, as
/// the cells above.
std::vector<Polygon> square_cells(const Figure& figure, double size, double angle);

/// What of a pattern that covers the plane lies in a figure; `size` is that of its cells. Sorted, and pieces and vertices
/// treated, as the cells above.
std::vector<Polygon> cells_in(const Figure& figure, const std::vector<Polygon>& pattern, double size);

/// Shares a number of cells over areas in proportion, at least one each (largest remainder).
std::vector<std::size_t> share(std::size_t count, const std::vector<double>& areas);

/// Cuts cells along the polylines wherever one runs through a cell; beyond a line's end the cut goes on to
/// the cell's border, where the two parts stay joined.
std::vector<Polygon> cut_cells(const std::vector<Polygon>& cells,
                               const std::vector<std::vector<Vec2>>& lines);

}  // namespace dda
