#pragma once

#include "meshing/layout.hpp"

namespace dda {

/// Throws InputError at `where` when so many blocks need more memory than there is (memory_limit): what takes
/// hours and ends in a crash is refused before it begins.
void require_room(double blocks, const Position& where);

/// Area of all shapes [L²].
double area_of(const Layout& layout);

}  // namespace dda
