#include "meshing/files/gmsh_model.hpp"

#include <filesystem>
#include <fstream>

#include "meshing/files/geo_scan.hpp"
#include "meshing/files/gmsh_process.hpp"
#include "meshing/files/mesh_file.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

bool& geo_trust() {
  static bool is_trusted = false;
  return is_trusted;
}

/// Where a geometry may read: its own folder, and that of the deck at `where`.
std::vector<fs::path> folders_of(const std::string& file, const Position& where) {
  std::error_code error;
  std::vector<fs::path> out{fs::absolute(file, error).parent_path()};
  if (fs::is_regular_file(where.file, error)) out.push_back(fs::absolute(where.file, error).parent_path());
  return out;
}

GmshTask task_of(const std::string& file, const Position& where, double seconds) {
  return {.open = {},
          .subject = "'" + fs::path(file).filename().string() + "'",
          .where = where,
          .folders = folders_of(file, where),
          .is_confined = !trusts_geo(),
          .seconds = seconds};
}

void require_file(const std::string& file, const Position& where) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) throw InputError(where, "there is no file '" + file + "'");
}

/// Anything else gmsh would take for a geometry, and execute.
void require_mesh(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string head;
  stream >> head;
  if (head != "$MeshFormat" && head != "$NOD")
    throw InputError({file, 1, 1}, "is no gmsh mesh: it does not begin with $MeshFormat");
}

}  // namespace

void set_geo_trust(bool is_trusted) { geo_trust() = is_trusted; }
bool trusts_geo() { return geo_trust(); }

std::shared_ptr<const GmshModel> GmshModel::from_geo(const std::string& file,
                                                     const GmshParameters& parameters, const Position& where,
                                                     double seconds) {
  require_file(file, where);
  GmshTask task = task_of(file, where, seconds);
  Findings findings;
  if (task.is_confined) refuse_commands(file, task.folders, findings);
  findings.throw_if_any();
  task.open = [&](const GmshModule& gmsh) { return gmsh.from_geo(file, parameters, where); };
  return std::make_shared<GmshProcess>(std::move(task));
}

std::shared_ptr<const GmshModel> GmshModel::from_msh(const std::string& file, const Position& where,
                                                     double seconds) {
  if (auto model = read_mesh_file(file, where)) return model;
  require_mesh(file);
  GmshTask task = task_of(file, where, seconds);
  task.is_confined = true;
  task.open = [&](const GmshModule& gmsh) { return gmsh.from_msh(file, where); };
  return std::make_shared<GmshProcess>(std::move(task));
}

std::shared_ptr<const GmshModel> GmshModel::from_layout(const Layout& layout) {
  GmshTask task{.open = [&](const GmshModule& gmsh) { return gmsh.from_layout(layout); },
                .subject = "these polygons",
                .where = layout.where,
                .folders = {},
                .is_confined = true,
                .seconds = layout.meshing_seconds};
  return std::make_shared<GmshProcess>(std::move(task));
}

}  // namespace dda
