#pragma once

#include <string>

#include "framework/base/errors.hpp"

namespace dda {

/// The line of a file that a finding is about, and below it a caret at its column; "" where there is no such line.
///
///        12 |     strengh: 3
///           |     ^~~~~~~
///
/// Columns count characters of UTF-8, as positions do. Of a long line the part around the column is shown.
std::string excerpt(const Position& where);

/// What the error says, each finding that has a place followed by its excerpt; with colours the place
/// is bold, `error:` before the rest and the caret red.
std::string with_excerpts(const InputError& error, bool with_colours = false);

}  // namespace dda
