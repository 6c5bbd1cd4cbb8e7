#include "meshing/gmsh/mesh_reader.hpp"

#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace dda {
namespace {

NodePlaces nodes_of(int dimension, int tag) {
  std::vector<std::size_t> tags;
  std::vector<double> coordinates, parameters;
  gmsh::model::mesh::getNodes(tags, coordinates, parameters, dimension, tag, true, false);
  NodePlaces places;
  for (std::size_t i = 0; i < tags.size(); ++i)
    places[tags[i]] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
  return places;
}

struct Elements {
  std::vector<int> types;
  std::vector<std::vector<std::size_t>> tags, nodes;
};

Elements elements_of(int dimension, int tag) {
  Elements e;
  gmsh::model::mesh::getElements(e.types, e.tags, e.nodes, dimension, tag);
  return e;
}

/// Corners of first-order plane elements by gmsh's type number; 0 for all others.
std::size_t corners(int type) { return type == 2 ? 3 : type == 3 ? 4 : 0; }

Polygon face(const std::size_t* nodes, std::size_t count, const NodePlaces& places) {
  Polygon outline;
  for (std::size_t i = 0; i < count; ++i) outline.vertices.push_back(places.at(nodes[i]).head<2>());
  return outline;
}

/// As gmsh turns them.
std::vector<Polygon> turned_faces(int surface, const NodePlaces& places, const Position& where) {
  const Elements elements = elements_of(2, surface);
  std::vector<Polygon> faces;
  for (std::size_t t = 0; t < elements.types.size(); ++t) {
    const std::size_t count = corners(elements.types[t]);
    if (count == 0)
      throw InputError(where,
                       "the mesh has elements that are no three-node triangles or four-node quadrilaterals");
    for (std::size_t i = 0; i + count <= elements.nodes[t].size(); i += count)
      faces.push_back(face(&elements.nodes[t][i], count, places));
  }
  return faces;
}

void require_plane(const NodePlaces& places, const Position& where) {
  double height = 0, width = 0;
  for (const auto& [tag, x] : places) {
    height = std::max(height, std::abs(x.z()));
    width = std::max(width, x.head<2>().cwiseAbs().maxCoeff());
  }
  if (height > 1e-9 * width) throw InputError(where, "the mesh leaves the plane z = 0");
}

using EdgesAtNode = std::map<std::size_t, std::vector<std::size_t>>;

/// Edges of all border curves; a curve that the border walks twice (a seam) belongs to neither loop.
std::vector<MeshEdge> border_edges(int surface, const NodePlaces& places) {
  gmsh::vectorpair curves;
  gmsh::model::getBoundary({{2, surface}}, curves, false, false, false);
  std::map<int, int> visits;
  for (const auto& [dimension, tag] : curves) ++visits[std::abs(tag)];
  std::vector<MeshEdge> edges;
  for (const auto& [curve, count] : visits)
    if (count == 1)
      for (const MeshEdge& edge : mesh_edges(curve, places)) edges.push_back(edge);
  return edges;
}

/// Takes unused edges one after another, from node to node, until the loop closes.
Polygon walk(const std::vector<MeshEdge>& edges, const EdgesAtNode& at, std::vector<bool>& used,
             std::size_t first) {
  Polygon loop;
  std::size_t edge = first, node = edges[first].from;
  while (!used[edge]) {
    used[edge] = true;
    const bool forward = edges[edge].from == node;
    loop.vertices.push_back(forward ? edges[edge].start : edges[edge].end);
    node = forward ? edges[edge].to : edges[edge].from;
    for (const std::size_t next : at.at(node))
      if (!used[next]) edge = next;
  }
  return counter_clockwise(loop);
}

}  // namespace

NodePlaces mesh_nodes(const Frame& frame, const Position& where) {
  NodePlaces places = nodes_of(-1, -1);
  require_plane(places, where);
  for (auto& [tag, x] : places) x.head<2>() = frame.outer(Vec2(x.head<2>()));
  return places;
}

std::vector<Polygon> mesh_faces(int surface, const NodePlaces& places, const Position& where) {
  std::vector<Polygon> faces = turned_faces(surface, places, where);
  for (Polygon& outline : faces) outline = counter_clockwise(std::move(outline));
  return faces;
}

std::optional<Vec2> fold(int surface, const NodePlaces& places, const Position& where) {
  const std::vector<Polygon> faces = turned_faces(surface, places, where);
  const auto turns_left = [](const Polygon& outline) { return signed_area(outline) > 0; };
  const bool most = 2 * std::ranges::count_if(faces, turns_left) > std::ssize(faces);
  const auto other = std::ranges::find(faces, !most, turns_left);
  return other == faces.end() ? std::nullopt : std::optional(other->vertices.front());
}

std::vector<MeshEdge> mesh_edges(int curve, const NodePlaces& places) {
  const Elements elements = elements_of(1, curve);
  std::vector<MeshEdge> edges;
  for (std::size_t t = 0; t < elements.types.size(); ++t) {
    const std::size_t stride = elements.nodes[t].size() / std::max<std::size_t>(elements.tags[t].size(), 1);
    for (std::size_t i = 0; i < elements.nodes[t].size(); i += stride) {
      const std::size_t a = elements.nodes[t][i], b = elements.nodes[t][i + 1];
      edges.push_back({a, b, places.at(a).head<2>(), places.at(b).head<2>()});
    }
  }
  return edges;
}

Vec2 mesh_point(int point) {
  const NodePlaces places = nodes_of(0, point);
  if (!places.empty()) return places.begin()->second.head<2>();
  std::vector<double> x;
  gmsh::model::getValue(0, point, {}, x);
  return {x[0], x[1]};
}

Figure boundary_loops(int surface, const NodePlaces& places) {
  const std::vector<MeshEdge> edges = border_edges(surface, places);
  EdgesAtNode at;
  std::vector<Vec2> all;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    at[edges[e].from].push_back(e);
    at[edges[e].to].push_back(e);
    all.push_back(edges[e].start);
  }
  const double tolerance = 1e-9 * bounding_box(all).size();
  std::vector<bool> used(edges.size(), false);
  std::vector<Polygon> loops;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (!used[e]) loops.push_back(without_collinear(walk(edges, at, used, e), tolerance));
  // The border around a surface encloses all others.
  std::sort(loops.begin(), loops.end(),
            [](const Polygon& a, const Polygon& b) { return signed_area(a) > signed_area(b); });
  if (loops.empty()) return {};
  return {loops.front(), {loops.begin() + 1, loops.end()}};
}

}  // namespace dda
