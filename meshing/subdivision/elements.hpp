#pragma once

#include "framework/deck/schema.hpp"
#include "meshing/files/gmsh_model.hpp"

namespace dda {

/// What a deck says of triangles and quads alike.
struct ElementParameters {
  std::optional<double> size;
  std::optional<Refinement> refine;
  Position where;
};

Schema<ElementParameters> element_schema(std::string text);

/// Elements of one shape over the whole layout, conforming across regions and along all lines.
/// Throws InputError when a scene of polygons comes without a size.
Cells divide_into_elements(const Layout& layout, const ElementParameters& parameters, bool quads);

}  // namespace dda
