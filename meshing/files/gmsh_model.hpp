#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meshing/layout.hpp"

namespace dda {

/// Finer elements near a named curve.
struct Refinement {
  std::string curve;
  double size = 0;      ///< element size on the curve [L]
  double growth = 0.2;  ///< increase of the element size per distance from it
};

/// What elements gmsh is to make. `size` 0 leaves the sizes to the geometry file.
struct ElementWish {
  double size = 0;
  bool quads = false;  ///< recombine triangles; some may remain
  std::optional<Refinement> refine;
};

using GmshParameters = std::map<std::string, double>;

/// A geometry or mesh held by gmsh, in a process of its own that is started for it and ended with it
/// (GmshProcess); or a mesh read from a file without it.
///
/// That process loads gmsh with a module: its libraries take 0.07 s to load, which a scene of polygons and
/// Voronoi cells or a mesh file need not pay.
///
/// Roles come from the names of physical groups:
///     surfaces   material:NAME or material:NAME/REGION
///     curves     interface:NAME, boundary:NAME, slit:NAME
///     points     point:NAME (or gauge:NAME): a place that the deck names, `at: NAME`
/// All surfaces of one group are one region. Groups are told apart by (dimension, tag), names by role.
/// Throws InputError for a missing file, a syntax error (with the line in that file), an untagged surface,
/// an unknown role, an entity in two groups of one role, commands that a geometry may not give
/// (refuse_commands), and when gmsh fails or takes longer than `seconds`. gmsh itself prints nothing.
class GmshModel {
 public:
  /// A .geo file; parameters replace the values of DefineConstant, by variable name or by ONELAB name.
  static std::shared_ptr<const GmshModel> from_geo(const std::string& file, const GmshParameters& parameters,
                                                   const Position& where, double seconds = 600);
  /// A .msh file; versions 4.1 and 2.2 in ASCII without gmsh, other formats through it.
  static std::shared_ptr<const GmshModel> from_msh(const std::string& file, const Position& where,
                                                   double seconds = 600);
  /// Polygons, cut along their common borders and along the layout's lines.
  static std::shared_ptr<const GmshModel> from_layout(const Layout& layout);

  GmshModel() = default;
  virtual ~GmshModel() = default;
  GmshModel(const GmshModel&) = delete;
  GmshModel& operator=(const GmshModel&) = delete;

  /// Regions, outlines (curved borders as the file's element sizes divide them), lines and points.
  virtual Layout layout() const = 0;

  /// Triangles or quadrilaterals; of a .msh file those in it, whatever is wished.
  virtual Cells mesh(const ElementWish& wish) const = 0;
};

/// Whether a .geo file may use the whole language of gmsh, which runs programs and writes files. Off at
/// first.
void set_geo_trust(bool is_trusted);
bool trusts_geo();

/// What the gmsh module gives out under the symbol `dda_gmsh_module`.
struct GmshModule {
  void (*confine)(const std::vector<std::filesystem::path>& folders);
  std::shared_ptr<const GmshModel> (*from_geo)(const std::string&, const GmshParameters&, const Position&);
  std::shared_ptr<const GmshModel> (*from_msh)(const std::string&, const Position&);
  std::shared_ptr<const GmshModel> (*from_layout)(const Layout&);
};

}  // namespace dda
