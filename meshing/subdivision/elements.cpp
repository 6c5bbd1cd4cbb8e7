#include "meshing/subdivision/elements.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "meshing/room.hpp"

namespace dda {
namespace {

Schema<Refinement> refinement_schema() {
  return Schema<Refinement>("Finer elements near a named curve.")
      .text("curve", &Refinement::curve, {.text = "Name of a curve of the scene."})
      .number("size", &Refinement::size,
              {.dimension = dimension::length, .bounds = above(0), .text = "Element size on the curve."})
      .number("growth", &Refinement::growth,
              {.fallback = 0.2,
               .bounds = above(0),
               .text = "Increase of the element size per distance from it."});
}

bool has_curve(const Layout& layout, const std::string& name) {
  return std::any_of(layout.lines.begin(), layout.lines.end(),
                     [&](const NamedLine& l) { return l.name == name; });
}

void check_parameters(const ElementParameters& parameters, const Layout& layout) {
  if (!layout.model && !parameters.size)
    throw InputError(parameters.where, "polygons need the parameter 'size' to be meshed");
  if (!parameters.refine) return;
  if (!parameters.size) throw InputError(parameters.where, "'refine' needs the parameter 'size' as well");
  if (parameters.refine->size > *parameters.size)
    throw InputError(parameters.where, "refine.size must be at most the size elsewhere");
  if (!has_curve(layout, parameters.refine->curve))
    throw InputError(parameters.where,
                     "refine.curve: the scene has no curve '" + parameters.refine->curve + "'");
}

double length_of(const Layout& layout, const std::string& curve) {
  double sum = 0;
  for (const NamedLine& line : layout.lines)
    for (std::size_t i = 0; line.name == curve && i + 1 < line.points.size(); ++i)
      sum += (line.points[i + 1] - line.points[i]).norm();
  return sum;
}

/// Area over that of an element, and beside a curve of length l up to a distance R, where h = h0 + g r,
/// l ∫ dr / h² = l R / (h0 (h0 + g R)).
void require_room_for(const ElementParameters& parameters, const Layout& layout, bool quads) {
  if (!parameters.size) return;
  const double of_unit = quads ? 1 : std::sqrt(3) / 4;
  double blocks = area_of(layout) / (of_unit * *parameters.size * *parameters.size);
  if (const auto& fine = parameters.refine) {
    const double reach = scene_size(layout), far = fine->size + fine->growth * reach;
    blocks += length_of(layout, fine->curve) * reach / (of_unit * fine->size * far);
  }
  require_room(blocks, parameters.where);
}

/// The regions that have shapes, in their order: gmsh numbers those that are drawn, and others may stay undivided.
std::vector<int> drawn_regions(const Layout& layout) {
  std::set<int> out;
  for (const Shape& shape : layout.shapes) out.insert(shape.region);
  return {out.begin(), out.end()};
}

}  // namespace

Schema<ElementParameters> element_schema(std::string text) {
  return Schema<ElementParameters>(std::move(text))
      .number("size", &ElementParameters::size,
              {.dimension = dimension::length,
               .bounds = above(0),
               .text = "Length of an element's sides; without it as the geometry file says."})
      .section("refine", &ElementParameters::refine, refinement_schema());
}

Cells divide_into_elements(const Layout& layout, const ElementParameters& parameters, bool quads) {
  check_parameters(parameters, layout);
  require_room_for(parameters, layout, quads);
  const ElementWish wish{parameters.size.value_or(0), quads, parameters.refine};
  if (layout.model) return with_deck_lines(layout.model->mesh(wish), layout);
  Cells cells = GmshModel::from_layout(layout)->mesh(wish);
  const std::vector<int> regions = drawn_regions(layout);
  for (Cell& cell : cells.cells) cell.region = regions[static_cast<std::size_t>(cell.region)];
  // The polylines of the deck name the sides as well as the elements on them do, and are fewer.
  cells.lines = layout.lines;
  return cells;
}

}  // namespace dda
