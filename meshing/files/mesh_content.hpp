#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda {

/// What an ASCII .msh file says, in its own terms.
struct MeshContent {
  using Name = std::pair<int, int>;  ///< dimension, tag

  struct Entity {
    std::set<int> groups;                           ///< tags of its physical groups
    std::map<int, std::vector<std::size_t>> nodes;  ///< of its elements by type, in the order of the file
    std::optional<Vec2> place;                      ///< of a point
  };

  std::map<Name, std::string> group_names;
  std::map<Name, Entity> entities;
  std::unordered_map<std::size_t, Vec2> places;  ///< of the nodes
  double width = 0, height = 0;                  ///< largest |x|, |y| and |z| of the nodes
};

/// Nodes of an element of gmsh's type number: points, lines, triangles and quadrilaterals of first order; 0
/// for all others.
std::size_t num_nodes(int element_type);

/// Reads version 4.1 or 2.2; nothing of any other format. Sections other than $PhysicalNames, $Entities,
/// $Nodes and $Elements are skipped. Throws InputError with the line for what is no plane mesh of first
/// order. Source: the file formats of the Gmsh reference manual.
std::optional<MeshContent> read_mesh_content(const std::string& file);

}  // namespace dda
