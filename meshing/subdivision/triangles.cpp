#include "meshing/subdivision/elements.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {
namespace {

class Triangles final : public Subdivision {
 public:
  explicit Triangles(ElementParameters parameters) : parameters_(std::move(parameters)) {}
  Cells divide(const Layout& layout) const override {
    return divide_into_elements(layout, parameters_, false);
  }

 private:
  ElementParameters parameters_;
};

}  // namespace

DDA_REGISTER(subdivisions(), "triangles", element_schema("Triangles by gmsh."), make_of<Triangles>);

}  // namespace dda
