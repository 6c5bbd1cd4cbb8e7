#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

#include "framework/deck/changes/settings.hpp"

namespace dda {

namespace {

constexpr std::size_t line_width = 100;

bool is_alnum(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// Letters that mean nothing to YAML anywhere inside a plain scalar.
bool is_harmless(char c) {
  return is_alnum(c) || std::string_view("_./+- ()^*%").find(c) != std::string_view::npos;
}

/// Whether a text may stand without quotes, in a list as in a map. Rather too strict than too lax.
bool is_plain(const std::string& text) {
  if (text.empty() || text.back() == ' ' || text.size() > line_width) return false;
  for (const char* word : {"null", "Null", "NULL", "~"})
    if (text == word) return false;
  const bool is_signed = text.size() > 1 && std::string_view("+-.").find(text[0]) != std::string_view::npos;
  const bool starts_well =
      is_alnum(text[0]) || text[0] == '_' || text[0] == '/' || (is_signed && is_alnum(text[1]));
  return starts_well && std::all_of(text.begin(), text.end(), is_harmless);
}

std::string quote(const std::string& text) {
  std::string quoted = "\"";
  for (char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (c == '\n')
      quoted += "\\n";
    else if (code < 0x20 || code == 0x7f)
      quoted += fmt::format("\\x{:02x}", code);
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string scalar_text(const std::string& text, bool quoted) {
  return quoted || !is_plain(text) ? quote(text) : text;
}

constexpr std::size_t any_length = std::string::npos;

/// Adds one line: "null", "3", "[1, 2]", "[[0, 0], [1, 0]]", "{}", "{a: 1, b: [2, 3]}". What would come after
/// the limit may be left out.
void add_inline(std::string& line, const Node& node, std::size_t limit) {
  if (node.is_null()) line += "null";
  if (node.is_scalar()) line += scalar_text(node.text, node.quoted);
  if (node.is_null() || node.is_scalar()) return;
  line += node.is_map() ? "{" : "[";
  const char* between = "";
  for (const Node& item : node.items) {
    if (line.size() > limit) return;
    line += std::exchange(between, ", ");
    add_inline(line, item, limit);
  }
  for (const auto& [key, where, value] : node.entries) {
    if (line.size() > limit) return;
    line += std::exchange(between, ", ") + scalar_text(key, false) + ": ";
    add_inline(line, value, limit);
  }
  line += node.is_map() ? "}" : "]";
}

std::string inline_text(const Node& node) {
  std::string line;
  add_inline(line, node, any_length);
  return line;
}

bool holds_map(const Node& node) {
  return (node.is_map() && !node.entries.empty()) ||
         std::any_of(node.items.begin(), node.items.end(), holds_map);
}

/// The node where it stands in one line: every scalar, lists and maps that are short and hold no map.
std::optional<std::string> one_line(const Node& node) {
  if (node.is_null() || node.is_scalar()) return inline_text(node);
  if (holds_map(node)) return std::nullopt;
  std::string line;
  add_inline(line, node, line_width);
  return line.size() <= line_width ? std::optional(std::move(line)) : std::nullopt;
}

std::string block(const Node& node, std::size_t indent);

/// What follows "key:" or "-": the value on the same line, or a block on the next ones.
std::string after_marker(const Node& node, std::size_t indent) {
  const std::optional<std::string> line = one_line(node);
  return line ? " " + *line + "\n" : "\n" + block(node, indent);
}

/// A map under a dash starts on the dash's line.
std::string list_entry(const Node& item, std::size_t indent) {
  const std::string dash(indent, ' ');
  if (!item.is_map() || item.entries.empty()) return dash + "-" + after_marker(item, indent + 2);
  return dash + "- " + block(item, indent + 2).substr(indent + 2);
}

std::string block(const Node& node, std::size_t indent) {
  std::string text;
  for (const Node& item : node.items) text += list_entry(item, indent);
  for (const auto& [key, where, value] : node.entries) {
    const std::string start = std::string(indent, ' ') + scalar_text(key, false) + ":";
    text += start + after_marker(value, indent + 2);
  }
  return text;
}

}  // namespace

std::string to_yaml(const Node& node) {
  const std::optional<std::string> line = one_line(node);
  return line ? *line + "\n" : block(node, 0);
}

std::string to_flow_yaml(const Node& node) { return node.is_null() ? "" : inline_text(node); }

}  // namespace dda
