#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "framework/deck/schema.hpp"

namespace dda {

/// Shells that there is completion for: bash, zsh, fish.
std::vector<std::string> completion_shells();

/// What such a shell reads to complete `dda`: it asks `dda complete -- WORDS` whenever it is asked.
std::string completion_script(const std::string& shell);

/// What may come next on a command line, the last word of which is perhaps unfinished: a line each of the whole word, a
/// tabulator and what it means. A line ":deck", ":file" or ":folder" asks the shell for names of such files. Commands and
/// options are those of the program's grammar, keys those of the schema, and entries such as `interfaces.NAME` those of the
/// deck on the line, if it can be read.
std::string completions(const CLI::App& program, const SchemaBase& deck,
                        const std::vector<std::string>& words);

}  // namespace dda
