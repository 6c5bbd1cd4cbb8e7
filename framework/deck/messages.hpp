#pragma once

#include <map>
#include <string>

#include "framework/deck/kind.hpp"

namespace dda {

// What readers of values say, beside what kind.hpp has for the kinds of every part.

/// At most 60 letters of a text.
std::string shortened(const std::string& text);

/// "'x'", "a list": what stands in the place of a value.
std::string found(const Node& node);

/// Adds "name: what" at `where`.
void add_finding(const Position& where, const Reading& reading, const std::string& what);

/// A text, quoted where another YAML reader would see a number or a truth value.
Node echo_text(const std::string& text);

/// The values of the variables that expressions are read with (ReadingScope).
Kind<std::map<std::string, double>> variables_kind();

}  // namespace dda
