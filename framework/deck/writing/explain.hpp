#pragma once

#include <string>
#include <vector>

#include "framework/deck/schema.hpp"

namespace dda {

/// What is known of a parameter in a line: "number [F/L²], above 0, required".
std::string facts(const Parameter& parameter, const Units& units);

/// The manual of the deck, written from the declarations: what `dda explain <path>` prints.
///
///     ""                        the deck's sections and the families, one line each
///     "law"                     the members of a family
///     "law/linear_softening"    every parameter: unit, bounds, default or required, text
///     "path", "path/steps"      a section of the deck, however deep; '.' separates as '/' does
///
/// `deck` is the schema of the whole deck. InputError with a suggestion for an unknown name, of `others` that the caller
/// explains too.
std::string explain(const SchemaBase& deck, const std::string& path, const Units& units = {"L", "F"},
                    std::vector<std::string> others = {});

}  // namespace dda
