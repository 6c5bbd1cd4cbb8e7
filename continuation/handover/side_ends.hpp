#pragma once

#include <vector>

#include "continuation/bodies/bonds.hpp"
#include "continuation/handover/pieces.hpp"

namespace dda {

/// Contacts of the path whose points are inside their sides turn about these, and their corners sink into what is beside
/// them; in motion bodies meet by their corners. Bonds at the ends of such sides that bear pressure alone, with the
/// stiffness of the joint:
///
///     t_n = k min(q_n, 0),   q = [n s]ᵀ (x_second − x_first)
std::vector<Bond> ends_of_contacts(const Pieces& pieces);

}  // namespace dda
