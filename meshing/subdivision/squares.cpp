#include <numbers>

#include "meshing/geometry/voronoi.hpp"
#include "meshing/room.hpp"
#include "meshing/subdivision/parts.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

struct SquaresParameters {
  double size = 0, angle = 0;
  Position where;
};

class Squares final : public Subdivision {
 public:
  explicit Squares(SquaresParameters parameters) : parameters_(std::move(parameters)) {}
  Cells divide(const Layout& layout) const override {
    if (layout.model) require_sound(layout);
    require_room(area_of(layout) / (parameters_.size * parameters_.size), parameters_.where);
    const std::vector<LayoutPart> parts = parts_of(layout);
    constexpr double degree = std::numbers::pi / 180;
    return cells_of_parts(layout, parts, [&](std::size_t i) {
      return square_cells(parts[i].figure, parameters_.size, parameters_.angle * degree);
    });
  }

 private:
  SquaresParameters parameters_;
};

Schema<SquaresParameters> schema() {
  using P = SquaresParameters;
  return Schema<P>(
             "Squares in rows turned by an angle, cut at the outline; interfaces and slits are followed. Of "
             "any "
             "region, to see what a pattern does to a crack.")
      .number("size", &P::size,
              {.dimension = dimension::length, .bounds = above(0), .text = "Side of a square."})
      .number("angle", &P::angle,
              {.fallback = 0.0,
               .bounds = between(-180, 180),
               .text = "Of the rows to the x axis, in degrees, counter-clockwise."});
}

}  // namespace

DDA_REGISTER(subdivisions(), "squares", schema(), make_of<Squares>);

}  // namespace dda
