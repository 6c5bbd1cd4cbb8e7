#include "meshing/gmsh_model.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

#include "meshing/mesh_file.hpp"

namespace dda {
namespace {

constexpr const char* file_name = "dda_gmsh.so";

/// Beside the program when installed there, else where it was built.
std::string module_path() {
  std::error_code failure;
  const auto beside = std::filesystem::read_symlink("/proc/self/exe", failure).parent_path() / file_name;
  return std::filesystem::exists(beside, failure) ? beside.string() : DDA_GMSH_MODULE;
}

const GmshModule& load() {
  void* handle = dlopen(module_path().c_str(), RTLD_LAZY | RTLD_LOCAL);
  const void* symbol = handle ? dlsym(handle, "dda_gmsh_module") : nullptr;
  if (!symbol) throw std::runtime_error(std::string("cannot load gmsh: ") + dlerror());
  return *static_cast<const GmshModule*>(symbol);
}

/// Stays loaded: gmsh's libraries do not survive being unloaded and loaded again.
const GmshModule& module() {
  static const GmshModule& loaded = load();
  return loaded;
}

}  // namespace

std::shared_ptr<const GmshModel> GmshModel::from_geo(const std::string& file,
                                                     const GmshParameters& parameters,
                                                     const Position& where) {
  return module().from_geo(file, parameters, where);
}

std::shared_ptr<const GmshModel> GmshModel::from_msh(const std::string& file, const Position& where) {
  if (auto model = read_mesh_file(file, where)) return model;
  return module().from_msh(file, where);
}

std::shared_ptr<const GmshModel> GmshModel::from_layout(const Layout& layout) {
  return module().from_layout(layout);
}

}  // namespace dda
