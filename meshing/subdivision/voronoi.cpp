#include "meshing/geometry/voronoi.hpp"

#include <algorithm>
#include <cmath>

#include "meshing/room.hpp"
#include "meshing/subdivision/parts.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

struct VoronoiParameters {
  std::optional<std::int64_t> blocks;
  std::optional<double> size;
  std::int64_t seed = 1, iterations = 20;
  Position where;
};

class Voronoi final : public Subdivision {
 public:
  explicit Voronoi(VoronoiParameters parameters) : parameters_(std::move(parameters)) {}
  Cells divide(const Layout& layout) const override;

 private:
  std::vector<std::size_t> counts(const std::vector<LayoutPart>& parts) const;

  VoronoiParameters parameters_;
};

std::vector<std::size_t> Voronoi::counts(const std::vector<LayoutPart>& parts) const {
  std::vector<double> areas;
  for (const LayoutPart& part : parts) areas.push_back(area(part.figure));
  if (parameters_.blocks) return share(static_cast<std::size_t>(*parameters_.blocks), areas);
  std::vector<std::size_t> counts;
  for (const double a : areas)
    counts.push_back(
        static_cast<std::size_t>(std::max(1.0, std::round(a / (*parameters_.size * *parameters_.size)))));
  return counts;
}

Cells Voronoi::divide(const Layout& layout) const {
  if (layout.model) require_sound(layout);
  const double size = parameters_.size.value_or(0);
  require_room(
      parameters_.blocks ? static_cast<double>(*parameters_.blocks) : area_of(layout) / (size * size),
      parameters_.where);
  const TurnedLayout turned(layout);
  const std::vector<LayoutPart> parts = parts_of(turned.inner);
  const std::vector<std::size_t> blocks = counts(parts);
  return turned.back(cells_of_parts(turned.inner, parts, [&](std::size_t i) {
    // Parts of equal form must not get equal sites: each draws from its own seed.
    const VoronoiWish wish{blocks[i],
                           static_cast<std::uint64_t>(parameters_.seed) + 0x9e3779b97f4a7c15ULL * i,
                           static_cast<int>(parameters_.iterations)};
    return centroidal_voronoi(parts[i].figure, wish);
  }));
}

Schema<VoronoiParameters> schema() {
  using P = VoronoiParameters;
  return Schema<P>("Centroidal Voronoi cells from random sites; interfaces and slits are followed.")
      .integer(
          "blocks", &P::blocks,
          {.bounds = between(1, 1e7), .text = "Number of cells in the scene, shared by area; or give size."})
      .number(
          "size", &P::size,
          {.dimension = dimension::length, .bounds = above(0), .text = "Square root of the mean cell area."})
      .integer("seed", &P::seed, {.fallback = 1, .bounds = at_least(0), .text = "Selects the random sites."})
      .integer("iterations", &P::iterations,
               {.fallback = 20,
                .bounds = between(0, 10000),
                .text = "How often each site is moved to the centroid of its cell (Lloyd)."})
      .check([](const P& p, const Position& where, Findings& findings) {
        if (p.blocks.has_value() == p.size.has_value())
          findings.add(where, "voronoi needs either 'blocks' or 'size'");
      });
}

}  // namespace

DDA_REGISTER(subdivisions(), "voronoi", schema(), make_of<Voronoi>);

}  // namespace dda
