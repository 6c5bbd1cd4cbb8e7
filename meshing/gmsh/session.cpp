#include "meshing/gmsh/session.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "meshing/gmsh/drawing.hpp"
#include "meshing/gmsh/mesh_reader.hpp"

namespace dda {
namespace {

/// "'beam.geo', line 3: syntax error (;)" with the place it names; anything else at `where`.
InputError translated(const std::string& message, const Position& where) {
  static const std::regex place(R"('([^']+)', line (\d+): ?(.*))");
  std::smatch found;
  if (std::regex_search(message, found, place))
    return {Position{found[1], std::stoi(found[2]), 1}, "gmsh: " + found[3].str()};
  return {where, "gmsh: " + message};
}

/// A parameter that the file does not mention is a slip of the pen; files that read others may hide it there.
void require_mentioned(const GmshParameters& parameters, const std::string& file, const Position& where) {
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (text.find("Include") != std::string::npos || text.find("Merge") != std::string::npos) return;
  Findings findings;
  for (const auto& [name, value] : parameters)
    if (!std::regex_search(
            text, std::regex("\\b" + std::regex_replace(name, std::regex(R"([^\w/ ])"), ".") + "\\b")))
      findings.add(where, "'" + file + "' has no parameter '" + name + "'");
  findings.throw_if_any();
}

std::vector<std::string> arguments_for(const GmshParameters& parameters) {
  std::vector<std::string> arguments{"dda", "-v", "0"};
  for (const auto& [name, value] : parameters)
    arguments.insert(arguments.end(), {"-setnumber", name, fmt::format("{:.17g}", value)});
  return arguments;
}

}  // namespace

GmshSession::GmshSession(const std::vector<std::string>& arguments, Position where)
    : where_(std::move(where)) {
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  gmsh::initialize(static_cast<int>(words.size()), words.data(), false);
  gmsh::option::setNumber("General.Terminal", 0);
  // Parameters of an earlier model outlive gmsh's own finalisation.
  gmsh::onelab::clear();
  gmsh::model::add("scene");
}

GmshSession::~GmshSession() { gmsh::finalize(); }

void GmshSession::open(const std::string& file) {
  try {
    gmsh::merge(file);
  } catch (const std::string& message) {
    throw translated(message, {file, 0, 0});
  }
  double algorithm = 0;
  gmsh::option::getNumber("Mesh.Algorithm", algorithm);
  if (algorithm == 8)
    throw InputError({file, 0, 0},
                     "Mesh.Algorithm 8 crashes in gmsh 4.8; use 6 (and Mesh.RecombinationAlgorithm 1)");
  read_groups();
}

std::shared_ptr<const GmshModel> GmshSession::from_geo(const std::string& file,
                                                       const GmshParameters& parameters,
                                                       const Position& where) {
  require_mentioned(parameters, file, where);
  std::shared_ptr<GmshSession> model(new GmshSession(arguments_for(parameters), where));
  for (const auto& [name, value] : parameters) gmsh::onelab::setNumber(name, {value});
  model->open(file);
  return model;
}

std::shared_ptr<const GmshModel> GmshSession::from_msh(const std::string& file, const Position& where) {
  std::shared_ptr<GmshSession> model(new GmshSession(arguments_for({}), where));
  model->open(file);
  model->meshed_ = true;
  return model;
}

std::string GmshSession::centre_of(int dimension, int tag) const {
  double x0, y0, z0, x1, y1, z1;
  gmsh::model::getBoundingBox(dimension, tag, x0, y0, z0, x1, y1, z1);
  const Vec2 x = frame_.outer(Vec2{(x0 + x1) / 2, (y0 + y1) / 2});
  return fmt::format("{} (centre {:.6g}, {:.6g})", entity_text(dimension, tag), x.x(), x.y());
}

void GmshSession::read_groups() {
  gmsh::vectorpair tagged, entities;
  gmsh::model::getPhysicalGroups(tagged);
  for (const auto& [dimension, tag] : tagged) {
    std::string text;
    gmsh::model::getPhysicalName(dimension, tag, text);
    std::vector<int> members;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, tag, members);
    groups_.push_back(physical_group(dimension, tag, text, std::move(members)));
  }
  std::vector<int> surfaces;
  gmsh::model::getEntities(entities, 2);
  for (const auto& [dimension, tag] : entities) surfaces.push_back(tag);
  require_sound(
      groups_, surfaces, [this](int dimension, int tag) { return centre_of(dimension, tag); }, where_);
}

std::vector<Cell> GmshSession::elements() const {
  const NodePlaces places = mesh_nodes(frame_, where_);
  std::vector<Cell> cells;
  int region = 0;
  for (const PhysicalGroup& group : groups_) {
    if (group.dimension != 2) continue;
    for (const int surface : group.entities) {
      std::vector<Polygon> faces = mesh_faces(surface, places, where_);
      if (faces.empty()) throw InputError(where_, "gmsh made no element on " + centre_of(2, surface));
      for (Polygon& outline : faces) cells.push_back({std::move(outline), region});
    }
    ++region;
  }
  return cells;
}

std::vector<NamedLine> GmshSession::line_pieces() const {
  const NodePlaces places = mesh_nodes(frame_, where_);
  std::vector<NamedLine> lines;
  for (const PhysicalGroup& group : groups_) {
    if (group.dimension != 1) continue;
    for (const int curve : group.entities)
      for (const MeshEdge& edge : mesh_edges(curve, places))
        lines.push_back({line_role(group), group.name, {edge.start, edge.end}, where_, true});
  }
  return lines;
}

std::map<std::string, Vec2> GmshSession::named_points() const {
  std::map<std::string, Vec2> points;
  for (const PhysicalGroup& group : groups_)
    if (group.dimension == 0 && !group.entities.empty())
      points[group.name] = mesh_point(group.entities.front());
  return points;
}

std::vector<Shape> GmshSession::shapes() const {
  const NodePlaces places = mesh_nodes(frame_, where_);
  std::vector<Shape> shapes;
  int region = 0;
  for (const PhysicalGroup& group : groups_) {
    if (group.dimension != 2) continue;
    for (const int surface : group.entities)
      shapes.push_back({boundary_loops(surface, places), region, where_});
    ++region;
  }
  return shapes;
}

Layout GmshSession::layout() const {
  Layout layout;
  layout.where = where_;
  for (const PhysicalGroup& group : groups_)
    if (group.dimension == 2) layout.regions.push_back(region_of(group));
  try {
    if (!meshed_) gmsh::model::mesh::generate(1);
    layout.points = named_points();
    layout.lines = line_pieces();
    if (!meshed_) layout.shapes = shapes();
  } catch (const std::string& message) {
    throw translated(message, where_);
  }
  return layout;
}

Cells GmshSession::mesh(const ElementWish& wish) const {
  try {
    if (!meshed_) {
      gmsh::model::mesh::clear();
      apply(wish);
      gmsh::model::mesh::generate(2);
      auto x = fold_of_surfaces();
      if (wish.quads && x) {  // the optimisation of quads has folded the mesh over
        gmsh::model::mesh::clear();
        gmsh::option::setNumber("Mesh.RecombineOptimizeTopology", 0);
        gmsh::model::mesh::generate(2);
        x = fold_of_surfaces();
      }
      if (x)
        throw InputError(where_, fmt::format("gmsh's mesh folds over near ({:.4g}, {:.4g}); use another size",
                                             x->x(), x->y()));
    }
    return {elements(), line_pieces()};
  } catch (const std::string& message) {
    throw translated(message, where_);
  }
}

std::optional<Vec2> GmshSession::fold_of_surfaces() const {
  const NodePlaces places = mesh_nodes(frame_, where_);
  for (const PhysicalGroup& group : groups_) {
    if (group.dimension != 2) continue;
    for (const int surface : group.entities)
      if (const auto found = fold(surface, places, where_)) return found;
  }
  return {};
}

void GmshSession::apply(const ElementWish& wish) const {
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
  if (wish.size > 0) {
    gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
    gmsh::option::setNumber("Mesh.MeshSizeMax", frame_.inner(wish.size));
    if (!wish.refine) gmsh::option::setNumber("Mesh.MeshSizeMin", frame_.inner(wish.size));
  }
  if (wish.refine) refine(wish);
  if (!wish.quads) return;
  gmsh::option::setNumber("Mesh.Algorithm", 6);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombineOptimizeTopology", 5);  // its default
}

/// h(distance) = min(size, refined size + growth × distance) as a background field.
void GmshSession::refine(const ElementWish& wish) const {
  std::vector<double> curves;
  for (const PhysicalGroup& group : groups_)
    if (group.dimension == 1 && group.name == wish.refine->curve)
      curves.insert(curves.end(), group.entities.begin(), group.entities.end());
  if (curves.empty()) throw InputError(where_, "refine: there is no curve '" + wish.refine->curve + "'");
  const int near = gmsh::model::mesh::field::add("Distance"),
            size = gmsh::model::mesh::field::add("Threshold");
  gmsh::model::mesh::field::setNumbers(near, "CurvesList", curves);
  gmsh::model::mesh::field::setNumber(near, "NumPointsPerCurve", 200);
  gmsh::model::mesh::field::setNumber(size, "InField", near);
  gmsh::model::mesh::field::setNumber(size, "SizeMin", frame_.inner(wish.refine->size));
  gmsh::model::mesh::field::setNumber(size, "SizeMax", frame_.inner(wish.size));
  gmsh::model::mesh::field::setNumber(size, "DistMin", 0);
  gmsh::model::mesh::field::setNumber(size, "DistMax",
                                      frame_.inner((wish.size - wish.refine->size) / wish.refine->growth));
  gmsh::model::mesh::field::setAsBackgroundMesh(size);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
}

std::shared_ptr<const GmshModel> GmshSession::from_layout(const Layout& layout) {
  std::shared_ptr<GmshSession> model(new GmshSession(arguments_for({}), layout.where));
  model->frame_ = Frame(layout);
  try {
    draw(layout, model->frame_);
  } catch (const std::string& message) {
    throw translated(message, layout.where);
  }
  model->read_groups();
  return model;
}

}  // namespace dda
