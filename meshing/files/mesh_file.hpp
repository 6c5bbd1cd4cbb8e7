#pragma once

#include <memory>
#include <string>

#include "meshing/files/gmsh_model.hpp"

namespace dda {

/// The model of an ASCII .msh file of version 4.1 or 2.2, read without gmsh, whose libraries take longer to
/// load than all else that a small run does; null for any other format.
/// Throws InputError for a missing file, with the line for what is no mesh, and what GmshModel throws.
std::shared_ptr<const GmshModel> read_mesh_file(const std::string& file, const Position& where);

}  // namespace dda
