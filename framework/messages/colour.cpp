#include "framework/messages/colour.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace dda {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

int code_of(Colour colour) {
  switch (colour) {
    case Colour::bold:
      return 1;
    case Colour::red:
      return 31;
    case Colour::green:
      return 32;
    case Colour::yellow:
      return 33;
  }
  return 0;
}

}  // namespace

bool shows_colours(std::FILE* stream) {
  return isatty(fileno(stream)) == 1 && environment("NO_COLOR").empty() && environment("TERM") != "dumb";
}

std::string coloured(const std::string& text, Colour colour) {
  return fmt::format("\x1b[{}m{}\x1b[0m", code_of(colour), text);
}

std::string coloured_end(const std::string& line, int exit_code, std::FILE* stream) {
  constexpr int stopped = 3, interrupted = 130;
  if (!shows_colours(stream)) return line;
  if (exit_code == 0) return coloured(line, Colour::green);
  return coloured(line, exit_code == stopped || exit_code == interrupted ? Colour::yellow : Colour::red);
}

}  // namespace dda
