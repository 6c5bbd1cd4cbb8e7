#pragma once

#include "framework/deck/document/node.hpp"
#include "framework/deck/schema.hpp"

namespace dda {

/// A tree as JSON. Unquoted scalars that read as integers, finite numbers, `true` or `false` become such.
Json to_json(const Node& node);

}  // namespace dda
