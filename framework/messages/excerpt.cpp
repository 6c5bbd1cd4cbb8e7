#include "framework/messages/excerpt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "framework/messages/colour.hpp"

namespace dda {
namespace {

constexpr std::size_t longest_excerpt = 110, before_column = 60;  // characters
constexpr std::size_t longest_line = 1 << 16;                     // bytes; nobody wrote a longer one
constexpr std::size_t most_excerpts = 30;

/// A line of a file, from 1, as its characters, each of one byte or more.
std::optional<std::vector<std::string>> characters_of_line(const Position& where) {
  std::error_code failure;
  if (where.line < 1 || !std::filesystem::is_regular_file(where.file, failure)) return {};
  std::ifstream file(where.file, std::ios::binary);
  std::string line;
  for (int i = 0; i < where.line; ++i)
    if (!std::getline(file, line)) return {};
  if (line.size() > longest_line) return {};
  std::vector<std::string> characters;
  for (const char c : line) {
    const bool continues = (static_cast<unsigned char>(c) & 0xC0) == 0x80 && !characters.empty();
    const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
    if (continues)
      characters.back() += c;
    else if (c != '\r')
      characters.emplace_back(1, is_control ? ' ' : c);  // a tab too: one column
  }
  return characters;
}

/// Whether a character belongs to the word that is wrong.
bool is_of_word(const std::string& character) {
  return character.size() > 1 ||
         std::string_view(" ,:;{}[]()<>=\"'#").find(character) == std::string_view::npos;
}

std::string in_colours(const Finding& finding) {
  const std::string place = to_string(finding.where);
  return (place.empty() ? "" : coloured(place, Colour::bold) + ": ") + coloured("error:", Colour::red) + " " +
         finding.what;
}

std::string with_red_caret(const std::string& excerpt) {
  const std::size_t caret = excerpt.rfind('^');
  return excerpt.substr(0, caret) + coloured(excerpt.substr(caret), Colour::red);
}

}  // namespace

std::string excerpt(const Position& where) {
  const auto line = characters_of_line(where);
  if (!line || where.column < 1 || static_cast<std::size_t>(where.column) > line->size() + 1) return "";
  const auto column = static_cast<std::size_t>(where.column) - 1;
  const std::size_t from =
      line->size() > longest_excerpt && column > before_column ? column - before_column : 0;
  const std::size_t to = std::min(line->size(), from + longest_excerpt);
  std::size_t end = column + 1;
  while (end < to && column < line->size() && is_of_word((*line)[column]) && is_of_word((*line)[end])) ++end;
  const std::string number = std::to_string(where.line);
  std::string text = fmt::format("  {:>5} | ", number);
  for (std::size_t i = from; i < to; ++i) text += (*line)[i];
  text.erase(text.find_last_not_of(' ') + 1);
  return text + fmt::format("\n  {:>{}} | {}^{}", "", std::max<std::size_t>(5, number.size()),
                            std::string(column - from, ' '), std::string(end - column - 1, '~'));
}

std::string with_excerpts(const InputError& error, bool with_colours) {
  std::string text;
  const std::vector<Finding>& findings = error.findings();
  const std::size_t shown = std::min(findings.size(), most_excerpts);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::string said = InputError(findings[i].where, findings[i].what).what();
    const std::string line = excerpt(findings[i].where);
    text += (i ? "\n" : "") + (with_colours ? in_colours(findings[i]) : said);
    if (!line.empty()) text += "\n" + (with_colours ? with_red_caret(line) : line);
  }
  if (shown < findings.size()) text += fmt::format("\n... and {} more", findings.size() - shown);
  return text;
}

}  // namespace dda
