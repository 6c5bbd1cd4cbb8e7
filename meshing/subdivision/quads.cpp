#include "meshing/subdivision/elements.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

class Quads final : public Subdivision {
 public:
  explicit Quads(ElementParameters parameters) : parameters_(std::move(parameters)) {}
  Cells divide(const Layout& layout) const override {
    return divide_into_elements(layout, parameters_, true);
  }

 private:
  ElementParameters parameters_;
};

}  // namespace

DDA_REGISTER(subdivisions(), "quads",
             element_schema("Quadrilaterals recombined from triangles by gmsh; some triangles may remain."),
             make_of<Quads>);

}  // namespace dda
