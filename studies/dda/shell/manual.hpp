#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "framework/deck/schema.hpp"

namespace dda {

/// The manual page dda(1), in man(7): commands and options as the program's grammar declares them.
std::string program_page(const CLI::App& program, const SchemaBase& deck);

/// The manual page dda-deck(5): every key of decks with unit, bounds, default and text, as `dda explain` shows them.
std::string deck_page(const SchemaBase& deck);

}  // namespace dda
