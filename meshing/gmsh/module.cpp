#include "meshing/gmsh/confinement.hpp"
#include "meshing/gmsh/session.hpp"

/// The module's one symbol, looked up by name in gmsh_model.cpp.
extern "C" const dda::GmshModule dda_gmsh_module;
const dda::GmshModule dda_gmsh_module{&dda::confine, &dda::GmshSession::from_geo, &dda::GmshSession::from_msh,
                                      &dda::GmshSession::from_layout};
