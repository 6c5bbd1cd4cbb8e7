#include "meshing/room.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

enum class GridShape { quads, triangles };

struct GridParameters {
  std::int64_t columns = 1, rows = 1;
  GridShape shape = GridShape::quads;
  Position where;
};

/// Rows and columns in each four-cornered region: x(ξ, η) bilinear, columns along its first side.
class Grid final : public Subdivision {
 public:
  explicit Grid(GridParameters parameters) : parameters_(std::move(parameters)) {}
  Cells divide(const Layout& layout) const override;

 private:
  void add_patch(const Shape& shape, std::int64_t column, std::int64_t row, std::vector<Cell>& cells) const;

  GridParameters parameters_;
};

Vec2 place(const Polygon& p, double xi, double eta) {
  return (1 - eta) * ((1 - xi) * p.at(0) + xi * p.at(1)) + eta * ((1 - xi) * p.at(3) + xi * p.at(2));
}

void Grid::add_patch(const Shape& shape, std::int64_t column, std::int64_t row,
                     std::vector<Cell>& cells) const {
  const auto corner = [&](std::int64_t i, std::int64_t j) {
    return place(shape.figure.outline,
                 static_cast<double>(column + i) / static_cast<double>(parameters_.columns),
                 static_cast<double>(row + j) / static_cast<double>(parameters_.rows));
  };
  const Vec2 a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
  if (parameters_.shape == GridShape::quads) return cells.push_back({Polygon{{a, b, c, d}}, shape.region});
  // Diagonals alternate, so that the mesh prefers no direction.
  const bool rising = (column + row) % 2 == 0;
  cells.push_back({rising ? Polygon{{a, b, c}} : Polygon{{a, b, d}}, shape.region});
  cells.push_back({rising ? Polygon{{a, c, d}} : Polygon{{b, c, d}}, shape.region});
}

Cells Grid::divide(const Layout& layout) const {
  if (layout.model) require_sound(layout);
  const double per_cell = parameters_.shape == GridShape::triangles ? 2 : 1;
  require_room(per_cell * static_cast<double>(layout.shapes.size()) *
                   static_cast<double>(parameters_.columns) * static_cast<double>(parameters_.rows),
               parameters_.where);
  Cells result{{}, layout.lines};
  for (const Shape& shape : layout.shapes) {
    if (shape.figure.outline.size() != 4 || !shape.figure.holes.empty() || !is_convex(shape.figure.outline))
      throw InputError(shape.where, "a grid needs regions with four corners, convex and without holes");
    for (std::int64_t row = 0; row < parameters_.rows; ++row)
      for (std::int64_t column = 0; column < parameters_.columns; ++column)
        add_patch(shape, column, row, result.cells);
  }
  return result;
}

Schema<GridParameters> schema() {
  using P = GridParameters;
  return Schema<P>("Rows and columns of quadrilaterals or triangles in each four-cornered region.")
      .integer("columns", &P::columns,
               {.bounds = between(1, 1e5), .text = "Blocks along the region's first side."})
      .integer("rows", &P::rows, {.bounds = between(1, 1e5), .text = "Blocks along its second side."})
      .one_of("shape", &P::shape, {{"quads", GridShape::quads}, {"triangles", GridShape::triangles}},
              {.fallback = GridShape::quads, .text = "Triangles halve each quadrilateral."});
}

}  // namespace

DDA_REGISTER(subdivisions(), "grid", schema(), make_of<Grid>);

}  // namespace dda
