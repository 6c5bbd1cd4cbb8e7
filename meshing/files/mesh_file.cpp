#include "meshing/files/mesh_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "meshing/files/mesh_content.hpp"
#include "meshing/files/physical_groups.hpp"

namespace dda {
namespace {

class MeshFile final : public GmshModel {
 public:
  MeshFile(MeshContent content, Position where) : content_(std::move(content)), where_(std::move(where)) {
    if (content_.height > 1e-9 * content_.width) throw InputError(where_, "the mesh leaves the plane z = 0");
    for (const auto& [name, entities] : members()) {
      const auto text = content_.group_names.find(name);
      groups_.push_back(physical_group(name.first, name.second,
                                       text == content_.group_names.end() ? "" : text->second, entities));
    }
    std::vector<int> surfaces;
    for (const auto& [name, entity] : content_.entities)
      if (name.first == 2) surfaces.push_back(name.second);
    require_sound(
        groups_, surfaces, [this](int dimension, int tag) { return centre_of(dimension, tag); }, where_);
  }

  Layout layout() const override {
    Layout out;
    out.where = where_;
    out.lines = lines();
    for (const PhysicalGroup& group : groups_) {
      if (group.dimension == 2) out.regions.push_back(region_of(group));
      if (group.dimension == 0 && !group.entities.empty())
        out.points[group.name] = place_of(group.entities.front());
    }
    return out;
  }

  Cells mesh(const ElementWish&) const override {
    Cells out{{}, lines()};
    int region = 0;
    for (const PhysicalGroup& group : groups_) {
      if (group.dimension != 2) continue;
      for (const int surface : group.entities) add_faces(surface, region, out.cells);
      ++region;
    }
    return out;
  }

 private:
  const MeshContent::Entity& entity(int dimension, int tag) const {
    return content_.entities.at({dimension, tag});
  }

  /// The entities of each physical group.
  std::map<MeshContent::Name, std::vector<int>> members() const {
    std::map<MeshContent::Name, std::vector<int>> out;
    for (const auto& [name, entity] : content_.entities)
      for (const int group : entity.groups) out[{name.first, group}].push_back(name.second);
    return out;
  }

  std::string centre_of(int dimension, int tag) const {
    std::vector<Vec2> places;
    for (const auto& [type, nodes] : entity(dimension, tag).nodes)
      for (const std::size_t node : nodes) places.push_back(content_.places.at(node));
    if (places.empty()) return entity_text(dimension, tag);
    const Box box = bounding_box(places);
    const Vec2 centre = box.centre();
    return fmt::format("{} (centre {:.6g}, {:.6g})", entity_text(dimension, tag), centre.x(), centre.y());
  }

  Vec2 place_of(int point) const {
    const MeshContent::Entity& at = entity(0, point);
    constexpr int point_type = 15;
    if (const auto node = at.nodes.find(point_type); node != at.nodes.end())
      return content_.places.at(node->second.front());
    return at.place.value_or(Vec2::Zero());
  }

  std::vector<NamedLine> lines() const {
    std::vector<NamedLine> out;
    for (const PhysicalGroup& group : groups_) {
      if (group.dimension != 1) continue;
      for (const int curve : group.entities)
        for (const auto& [type, nodes] : entity(1, curve).nodes)
          for (std::size_t i = 0; i + 1 < nodes.size(); i += 2)
            out.push_back({line_role(group),
                           group.name,
                           {content_.places.at(nodes[i]), content_.places.at(nodes[i + 1])},
                           where_,
                           true});
    }
    return out;
  }

  void add_faces(int surface, int region, std::vector<Cell>& cells) const {
    const MeshContent::Entity& faces = entity(2, surface);
    if (faces.nodes.empty()) throw InputError(where_, "there is no element on " + entity_text(2, surface));
    for (const auto& [type, nodes] : faces.nodes)
      for (std::size_t i = 0; i < nodes.size(); i += num_nodes(type)) {
        Polygon outline;
        for (std::size_t k = i; k < i + num_nodes(type); ++k)
          outline.vertices.push_back(content_.places.at(nodes[k]));
        cells.push_back({counter_clockwise(std::move(outline)), region});
      }
  }

  MeshContent content_;
  Position where_;
  std::vector<PhysicalGroup> groups_;
};

}  // namespace

std::shared_ptr<const GmshModel> read_mesh_file(const std::string& file, const Position& where) {
  if (!std::filesystem::is_regular_file(file)) throw InputError(where, "there is no file '" + file + "'");
  std::optional<MeshContent> content = read_mesh_content(file);
  if (!content) return nullptr;
  return std::make_shared<MeshFile>(std::move(*content), where);
}

}  // namespace dda
