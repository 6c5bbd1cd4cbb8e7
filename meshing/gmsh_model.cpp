#include "meshing/gmsh_model.hpp"

#include "framework/loaded.hpp"
#include "meshing/mesh_file.hpp"

namespace dda {
namespace {

const GmshModule& module() {
  static const auto* loaded =
      static_cast<const GmshModule*>(symbol_of(module_file(DDA_GMSH_MODULE), "dda_gmsh_module"));
  return *loaded;
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
