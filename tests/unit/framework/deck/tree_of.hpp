#pragma once

#include <string>

#include "framework/deck/document/node.hpp"

namespace dda {

/// What the text of a file `a.yaml` is read to.
inline Node tree_of(const std::string& text) { return parse_yaml(text, "a.yaml"); }

}  // namespace dda
