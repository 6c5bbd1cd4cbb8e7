#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "meshing/geometry/geos.hpp"
#include "meshing/neighbours.hpp"
#include "meshing/scene/scene.hpp"

namespace dda {
namespace {

Block block_from(const Cell& cell) {
  const Polygon outline = counter_clockwise(cell.outline);
  return {outline, moments(outline), cell.region};
}

/// Index of a name in a list that grows as needed.
int index_in(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return names.push_back(name), static_cast<int>(names.size()) - 1;
  return static_cast<int>(found - names.begin());
}

const char* key(LineRole role) {
  return role == LineRole::interface ? "curve" : role == LineRole::boundary ? "boundary" : "slit";
}

/// Straight pieces of the named lines; their names go into the assembly.
std::vector<LinePiece> pieces_of(const std::vector<NamedLine>& lines, Assembly& assembly) {
  std::vector<LinePiece> pieces;
  for (const NamedLine& line : lines) {
    int name = 0;
    if (line.role == LineRole::interface) name = index_in(assembly.curves, line.name);
    if (line.role == LineRole::boundary) name = index_in(assembly.boundaries, line.name);
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
      pieces.push_back({line.role, name, line.points[i], line.points[i + 1]});
  }
  return pieces;
}

/// A line that no block's side lies on is a slip of the pen.
void check_used(const std::vector<NamedLine>& lines, const std::vector<bool>& used, Findings& findings) {
  std::map<std::pair<LineRole, std::string>, std::pair<bool, Position>> hit;
  std::size_t next = 0;
  for (const NamedLine& line : lines) {
    auto& [any, where] = hit.try_emplace({line.role, line.name}, false, line.where).first->second;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) any = used[next++] || any;
  }
  for (const auto& [line, state] : hit)
    if (!state.first)
      findings.add(state.second,
                   fmt::format("{} '{}' lies on no side of any block", key(line.first), line.second));
}

std::string place(const Cell& cell) {
  const Vec2 x = moments(cell.outline).centroid;
  return fmt::format("the block around ({:.6g}, {:.6g})", x.x(), x.y());
}

/// Cells read from a file may be anything; those made here are sound by construction.
void check_cells(const std::vector<Cell>& cells, const Position& where, Findings& findings) {
  if (cells.empty()) findings.add(where, "the scene has no block");
  std::vector<Polygon> outlines;
  for (const Cell& cell : cells) {
    if (const auto wrong = defect(cell.outline)) findings.add(where, place(cell) + " " + *wrong);
    outlines.push_back(cell.outline);
  }
  if (!findings.empty()) return;
  for (const auto& [i, j] : overlapping(outlines))
    findings.add(where, place(cells[j]) + " overlaps " + place(cells[i]));
}

Cells cells_of(const Scene& scene, const Layout& layout) {
  const auto subdivision = (scene.subdivision ? scene.subdivision : subdivisions().choose("given")).make();
  if (scene.type == SceneType::msh && scene.subdivision && scene.subdivision.name() != "given")
    throw InputError(scene.where, "a .msh file is taken as it is; its subdivision must be 'given'");
  return subdivision->divide(layout);
}

/// Regions that stay one block come behind the others, in their order.
Cells with_undivided(const Scene& scene, Layout layout) {
  std::vector<Cell> whole;
  std::erase_if(layout.shapes, [&](const Shape& shape) {
    const bool stays = !layout.model && scene.regions[static_cast<std::size_t>(shape.region)].is_undivided;
    if (stays) whole.push_back(uncut(shape, layout));
    return stays;
  });
  Cells out{{}, layout.lines};
  if (whole.empty() || !layout.shapes.empty()) out = cells_of(scene, layout);
  std::ranges::move(whole, std::back_inserter(out.cells));
  return out;
}

/// What has a region's name has to be somewhere.
void check_regions(const Assembly& assembly, const Position& where, Findings& findings) {
  for (std::size_t r = 0; r < assembly.regions.size(); ++r)
    if (std::ranges::none_of(assembly.blocks,
                             [&](const Block& b) { return static_cast<std::size_t>(b.region) == r; }))
      findings.add(
          where, "no block lies in region '" + assembly.regions[r].name + "'; is it covered by another one?");
}

Assembly meshed(const Scene& scene) {
  const Layout layout = layout_of(scene);
  const Cells cells = with_undivided(scene, layout);
  Findings findings;
  if (layout.model) check_cells(cells.cells, scene.where, findings);
  findings.throw_if_any();
  Assembly assembly;
  assembly.regions = layout.regions;
  assembly.points = layout.points;
  for (const Cell& cell : cells.cells) assembly.blocks.push_back(block_from(cell));
  check_regions(assembly, scene.where, findings);
  findings.throw_if_any();
  Neighbours found = find_neighbours(assembly.blocks, pieces_of(cells.lines, assembly));
  check_used(cells.lines, found.used, findings);
  findings.throw_if_any();
  assembly.sides = std::move(found.sides);
  assembly.boundary = std::move(found.boundary);
  return assembly;
}

}  // namespace

Assembly mesh(const Scene& scene) {
  try {
    return meshed(scene);
  } catch (const GeosError& error) {
    throw InputError(scene.where,
                     fmt::format("the scene's outlines cannot be cut into blocks; has each of them an "
                                 "area, and is the size of the blocks in proportion? ({})",
                                 error.what()));
  }
}

}  // namespace dda
