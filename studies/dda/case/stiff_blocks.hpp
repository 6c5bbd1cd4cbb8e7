#pragma once

#include <string>
#include <vector>

#include "models/body/body.hpp"

namespace dda {

/// Materials whose volume hardly changes, in blocks that cannot move so without being far too stiff.
std::vector<std::string> stiff_blocks(const Body& body);

}  // namespace dda
