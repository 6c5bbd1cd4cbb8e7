#pragma once

#include <functional>
#include <string>
#include <vector>

#include "framework/base/errors.hpp"
#include "meshing/assembly.hpp"
#include "meshing/neighbours.hpp"

namespace dda {

/// A named set of points (dimension 0), curves (1) or surfaces (2) of a gmsh geometry or mesh. The name tells
/// what it is for (GmshModel): "role:name".
struct PhysicalGroup {
  int dimension = 0, tag = 0;
  std::string role, name;
  std::vector<int> entities;
};

/// A group with the name "role:name".
PhysicalGroup physical_group(int dimension, int tag, const std::string& text, std::vector<int> entities);

/// "surface 2".
std::string entity_text(int dimension, int tag);

/// Throws InputError at `where` for groups with unknown roles, for entities with two names of one role and
/// for surfaces without a material; `describe(dimension, entity)` says where an entity lies.
void require_sound(const std::vector<PhysicalGroup>& groups, const std::vector<int>& surfaces,
                   const std::function<std::string(int, int)>& describe, const Position& where);

/// Region of a surface group: material before the slash, region's own name after it.
Region region_of(const PhysicalGroup& group);

/// What the sides on a curve group are for.
LineRole line_role(const PhysicalGroup& group);

}  // namespace dda
