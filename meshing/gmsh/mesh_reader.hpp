#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "framework/base/errors.hpp"
#include "meshing/geometry/polygon.hpp"
#include "meshing/gmsh/frame.hpp"

namespace dda {

/// A line element of the current gmsh model with the nodes it joins.
struct MeshEdge {
  std::size_t from = 0, to = 0;
  Vec2 start, end;
};

/// Node number → place in space, of the layout.
using NodePlaces = std::unordered_map<std::size_t, Eigen::Vector3d>;

/// All nodes of the current gmsh model. Throws InputError at `where` for nodes off the plane z = 0.
NodePlaces mesh_nodes(const Frame& frame, const Position& where);

/// Triangles and quadrilaterals of a surface of the current gmsh model, counter-clockwise.
/// Throws InputError at `where` for elements of higher order.
std::vector<Polygon> mesh_faces(int surface, const NodePlaces& places, const Position& where);

/// A vertex of an element that is turned against the others of its surface: there the mesh folds over.
std::optional<Vec2> fold(int surface, const NodePlaces& places, const Position& where);

/// Line elements of a curve of the current gmsh model.
std::vector<MeshEdge> mesh_edges(int curve, const NodePlaces& places);

/// Place of a point entity of the current gmsh model.
Vec2 mesh_point(int point);

/// Borders of a surface as its meshed boundary curves draw them, without vertices on straight pieces.
Figure boundary_loops(int surface, const NodePlaces& places);

}  // namespace dda
