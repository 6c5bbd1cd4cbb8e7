#pragma once

#include <string>

#include "framework/deck/schema.hpp"

namespace dda {

/// What the number at a dotted path of a deck measures; `none` for what is no number.
///
/// `deck` is the schema of the whole deck, `root` a deck with every default, which says what each family's
/// choice is.
Dimension dimension_of(const SchemaBase& deck, const Node& root, const std::string& path);

}  // namespace dda
