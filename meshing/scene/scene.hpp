#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/deck/family.hpp"
#include "meshing/assembly.hpp"
#include "meshing/subdivision/subdivision.hpp"

namespace dda {

/// Where the regions of a scene come from.
enum class SceneType { polygons, geo, msh };

/// A region given in place.
struct RegionInput {
  std::string name;  ///< the material's name when empty
  std::string material;
  std::vector<Vec2> vertices;  ///< [L], either direction
  bool is_undivided = false;   ///< one block, whatever the subdivision
  Position where;
};

/// The deck's `scene`: what there is, before it is cut into blocks.
struct Scene {
  using Lines = std::vector<std::pair<std::string, std::vector<Vec2>>>;

  SceneType type = SceneType::polygons;
  std::optional<std::filesystem::path> file;  ///< of geo and msh
  std::map<std::string, double> parameters;   ///< of geo
  std::vector<RegionInput> regions;           ///< of polygons
  Lines curves, boundaries, slits;            ///< polylines, added to those of a file
  Lines holes;                                ///< polygons, of a scene of polygons, where nothing is
  std::map<std::string, Vec2> points;
  double meshing_seconds = 600;     ///< that gmsh may take for one answer [s]
  Choice<Subdivision> subdivision;  ///< empty means `given`
  Position where;
};

Schema<Scene> scene_schema();

/// The scene's regions and lines, checked. Throws InputError with everything that is wrong with them.
Layout layout_of(const Scene& scene);

/// Cuts the scene into blocks and finds who touches whom. Throws InputError.
///
/// Blocks come in the order of the subdivision, counter-clockwise; regions and names in that of the deck or
/// of the physical groups' numbers. Every named line must lie on a side of some block.
Assembly mesh(const Scene& scene);

}  // namespace dda
