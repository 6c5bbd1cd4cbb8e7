#pragma once

#include <span>
#include <string>

#include "framework/base/errors.hpp"
#include "meshing/assembly.hpp"

namespace dda {

/// A boundary that is a plane of symmetry, and the interface that it becomes.
struct Mirror {
  std::string boundary, curve;
  Position where;
};

/// Makes the boundaries sides between each block and its own mirror image (Side::is_mirror). One that there is not, that is
/// not straight or is named twice is a finding.
void add_mirror_sides(Assembly& assembly, std::span<const Mirror> mirrors, Findings& findings);

}  // namespace dda
