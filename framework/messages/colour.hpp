#pragma once

#include <cstdio>
#include <string>

namespace dda {

enum class Colour { bold, red, green, yellow };

/// Whether a stream is a terminal whose user wants colours: NO_COLOR is empty or not set, and TERM is not `dumb`.
bool shows_colours(std::FILE* stream);

/// The text between the codes that terminals know.
std::string coloured(const std::string& text, Colour colour);

/// A line that tells how something ended, by its exit code: 0 green, 3 and 130 (stopped early) yellow, others red.
std::string coloured_end(const std::string& line, int exit_code, std::FILE* stream);

}  // namespace dda
