#include "meshing/files/gmsh_model.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

/// A polygon of the deck is a block; a geometry file is meshed as it says, a mesh file taken as it is.
class Given final : public Subdivision {
 public:
  Cells divide(const Layout& layout) const override {
    if (layout.model) return with_deck_lines(layout.model->mesh({}), layout);
    std::vector<Cell> cells;
    for (const Shape& shape : layout.shapes) cells.push_back(uncut(shape, layout));
    return {std::move(cells), layout.lines};
  }
};

Schema<NoParameters> schema() {
  return Schema<NoParameters>(
      "Each polygon is one block; elements of a .msh file and of a .geo file meshed as it says likewise.");
}

}  // namespace

DDA_REGISTER(subdivisions(), "given", schema(), make_of<Given>);

}  // namespace dda
