#include "meshing/scene/scene.hpp"

#include "meshing/files/gmsh_model.hpp"
#include "meshing/scene/holes.hpp"

namespace dda {
namespace {

Schema<RegionInput> region_schema() {
  return Schema<RegionInput>("A polygon of one material.")
      .text("name", &RegionInput::name,
            {.fallback = "", .text = "Name of the region; the material's when not given."})
      .text("material", &RegionInput::material, {.text = "Name of a material of the deck."})
      .points("vertices", &RegionInput::vertices,
              {.at_least = 3, .text = "Corners in order, first not repeated."})
      .boolean(
          "undivided", &RegionInput::is_undivided,
          {.fallback = false,
           .text = "The polygon is one block whatever the `subdivision`, such as a ground, a plate or a pier "
                   "beside what cracks."});
}

Kind<std::vector<Vec2>> polyline() { return list_of(point_kind(), 2); }

/// Which keys go with which type.
void check_keys(const Scene& scene, const Position& where, Findings& findings) {
  const bool polygons = scene.type == SceneType::polygons;
  if (!polygons && !scene.file) findings.add(where, "a scene of type geo or msh needs the parameter 'file'");
  if (polygons && scene.file)
    findings.add(where, "a scene of polygons has no 'file'; set type to geo or msh");
  if (!polygons && !scene.regions.empty())
    findings.add(where, "'regions' belong to a scene of type polygons");
  if (!polygons && !scene.holes.empty())
    findings.add(where, "'holes' belong to a scene of type polygons; draw those of a gmsh file in it");
  if (polygons && scene.regions.empty())
    findings.add(where, "a scene of polygons needs at least one entry of 'regions'");
  if (scene.type != SceneType::geo && !scene.parameters.empty())
    findings.add(where, "'parameters' belong to a scene of type geo");
}

void add_lines(const Scene::Lines& lines, LineRole role, const Position& where, Layout& layout) {
  for (const auto& [name, points] : lines) layout.lines.push_back({role, name, points, where});
}

void add_region(const RegionInput& input, Layout& layout) {
  const std::string name = input.name.empty() ? input.material : input.name;
  const int number = static_cast<int>(layout.regions.size());
  layout.regions.push_back({name, input.material});
  layout.shapes.push_back({{counter_clockwise({input.vertices}), {}}, number, input.where});
}

std::vector<Hole> holes_of(const Scene& scene) {
  std::vector<Hole> out;
  for (const auto& [name, corners] : scene.holes)
    out.push_back({name, counter_clockwise({corners}), scene.where});
  return out;
}

Layout polygons_of(const Scene& scene) {
  Layout layout;
  for (const RegionInput& region : scene.regions) add_region(region, layout);
  return layout;
}

Layout file_of(const Scene& scene) {
  if (!scene.file) throw InputError(scene.where, "a scene of type geo or msh needs the parameter 'file'");
  const std::string file = scene.file->string();
  const auto model = scene.type == SceneType::geo
                         ? GmshModel::from_geo(file, scene.parameters, scene.where, scene.meshing_seconds)
                         : GmshModel::from_msh(file, scene.where, scene.meshing_seconds);
  Layout layout = model->layout();
  layout.model = model;
  return layout;
}

}  // namespace

Schema<Scene> scene_schema() {
  return Schema<Scene>("What there is: regions of materials, named curves, and how they are cut into blocks.")
      .one_of("type", &Scene::type,
              {{"polygons", SceneType::polygons}, {"geo", SceneType::geo}, {"msh", SceneType::msh}},
              {.fallback = SceneType::polygons,
               .text = "Polygons given here, a gmsh geometry, or a gmsh mesh (4.1, 2.2)."})
      .file("file", &Scene::file, {.text = "The .geo or .msh file."})
      .map("parameters", &Scene::parameters, number_kind(),
           {.text = "Values for DefineConstant of the .geo file, by variable or ONELAB name."})
      .list("regions", &Scene::regions, region_schema(),
            {.text = "Polygons; where they touch, their blocks are joined."})
      .map("curves", &Scene::curves, polyline(),
           {.text = "Polylines whose sides get the interface of that name."})
      .map("boundaries", &Scene::boundaries, polyline(),
           {.text = "Polylines on the outline, for loads and supports."})
      .map("slits", &Scene::slits, polyline(),
           {.text = "Polylines across which nothing is joined: notches of no width."})
      .map("holes", &Scene::holes, list_of(point_kind(), 3),
           {.text = "Polygons where nothing is, such as a tunnel or a window: taken away from the regions "
                    "that they lie in or cross. The outline of each is a boundary of its name."})
      .map("points", &Scene::points, point_kind(),
           {.text = "Named places: `at: name` means one wherever the deck points at a place. A gmsh file "
                    "names its own by "
                    "physical points point:NAME."})
      .number("meshing_seconds", &Scene::meshing_seconds,
              {.fallback = 600,
               .bounds = above(0),
               .text = "Longest time for gmsh to read the file and to mesh [s]."})
      .choice("subdivision", &Scene::subdivision, subdivisions(),
              {.fallback = "given", .text = "How regions are cut into blocks."})
      .check(check_keys);
}

Layout layout_of(const Scene& scene) {
  Layout layout = scene.type == SceneType::polygons ? polygons_of(scene) : file_of(scene);
  layout.where = scene.where;
  layout.meshing_seconds = scene.meshing_seconds;
  add_lines(scene.curves, LineRole::interface, scene.where, layout);
  add_lines(scene.boundaries, LineRole::boundary, scene.where, layout);
  add_lines(scene.slits, LineRole::slit, scene.where, layout);
  Findings findings;
  for (const auto& [name, x] : scene.points)
    if (!layout.points.try_emplace(name, x).second)
      findings.add(scene.where, "the file and `scene.points` both name a point '" + name + "'");
  // Outlines of a file are gmsh's own to check; its cells are checked once they are there.
  if (scene.type == SceneType::polygons) check(layout, findings);
  findings.throw_if_any();
  cut_holes(holes_of(scene), layout, findings);
  findings.throw_if_any();
  return layout;
}

}  // namespace dda
