#include "meshing/subdivision/parts.hpp"

#include "framework/base/threads.hpp"
#include "meshing/geometry/voronoi.hpp"

namespace dda {
namespace {

/// Lines that cells have to follow: boundaries lie on the outline anyway.
std::vector<std::vector<Vec2>> inner_lines(const Layout& layout) {
  std::vector<std::vector<Vec2>> lines;
  for (const NamedLine& line : layout.lines)
    if (line.role != LineRole::boundary) lines.push_back(line.points);
  return lines;
}

}  // namespace

std::vector<LayoutPart> parts_of(const Layout& layout) {
  std::vector<LayoutPart> parts;
  for (const Shape& shape : layout.shapes)
    for (Figure& figure : cut(shape.figure, inner_lines(layout))) {
      figure.outline = without_collinear(figure.outline, 1e-9 * scene_size(layout));
      parts.push_back({std::move(figure), shape.region});
    }
  return parts;
}

Cells cells_of_parts(const Layout& layout, const std::vector<LayoutPart>& parts,
                     const std::function<std::vector<Polygon>(std::size_t)>& cells) {
  std::vector<std::vector<Polygon>> made(parts.size());
  parallel_for(parts.size(), 1, [&](std::size_t i) { made[i] = cut_cells(cells(i), inner_lines(layout)); });
  Cells result{{}, layout.lines};
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (Polygon& cell : made[i]) result.cells.push_back({std::move(cell), parts[i].region});
  return result;
}

}  // namespace dda
