#pragma once

#include <filesystem>
#include <vector>

#include "framework/base/errors.hpp"

namespace dda {

/// Looks through a .geo file, and through those it includes or merges, for commands of gmsh's language that
/// reach beyond the geometry: that run programs, write files, end the process, read outside `folders`, or are
/// themselves made at run time. Tells all of them with file, line and column; nothing is executed.
///
/// The words are cut as gmsh's own scanner cuts them: comments, texts in "" and '' without escapes.
/// Source: Gmsh 4.8, Parser/Gmsh.l and Gmsh.y; the reference manual's list of commands.
void refuse_commands(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders,
                     Findings& findings);

}  // namespace dda
