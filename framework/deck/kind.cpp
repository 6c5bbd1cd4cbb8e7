#include "framework/deck/kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "framework/base/suggestion.hpp"
#include "framework/deck/expression/reading_scope.hpp"
#include "framework/deck/family.hpp"
#include "framework/deck/messages.hpp"

namespace dda {

namespace {

std::optional<std::string> read_text(const Node& node, const Reading& reading) {
  if (node.is_scalar()) return node.text;
  expected("a text", node, reading);
  return {};
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string entries(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

bool has_enough(std::size_t count, std::size_t at_least, const Node& node, const Reading& reading) {
  if (count >= at_least) return true;
  add_finding(node.where, reading,
              "must have at least " + entries(at_least) + ", got " + std::to_string(count));
  return false;
}

}  // namespace

std::string KindInfo::words() const {
  switch (form) {
    case Form::number:
      return "number";
    case Form::integer:
      return "integer";
    case Form::boolean:
      return "true or false";
    case Form::text:
      return "text";
    case Form::name:
      return "one of " + joined(names);
    case Form::file:
      return "file";
    case Form::point:
      return "point [x, y]";
    case Form::spot:
      return "point [x, y], or the name of one";
    case Form::section:
      return "section";
    case Form::family:
      return "a " + family->name();
    case Form::list:
      return (names.empty() ? "" : fmt::format("`{}`, or ", fmt::join(names, "`, `"))) +
             "list of: " + item->words();
    case Form::map:
      return "map from names to: " + item->words();
    case Form::anything:
      break;
  }
  return "anything";
}

std::string shortened(const std::string& text) {
  return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

std::string found(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::sequence:
      return "a list";
    case Node::Kind::map:
      return "a map";
    default:
      return (node.quoted ? "the text '" : "'") + shortened(node.text) + "'";
  }
}

void add_finding(const Position& where, const Reading& reading, const std::string& what) {
  reading.findings.add(where, reading.name.empty() ? what : reading.name + ": " + what);
}

void expected(const std::string& what, const Node& node, const Reading& reading) {
  add_finding(node.where, reading, "expected " + what + ", found " + found(node));
}

void too_large(const Node& node, const Reading& reading) {
  add_finding(node.where, reading, shortened(node.text) + " is out of range");
}

std::optional<std::size_t> read_name(const Node& node, const std::vector<std::string>& names,
                                     const Reading& reading) {
  if (!node.is_scalar()) {
    expected("a name", node, reading);
    return {};
  }
  const auto at = std::find(names.begin(), names.end(), node.text);
  if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
  add_finding(node.where, reading,
              "unknown value '" + shortened(node.text) + "'" + suggest(node.text, names));
  return {};
}

bool is_list(const Node& node, std::size_t at_least, const Reading& reading) {
  if (node.is_sequence()) return has_enough(node.items.size(), at_least, node, reading);
  expected("a list", node, reading);
  return false;
}

bool is_map_of(const Node& node, std::size_t at_least, const Reading& reading) {
  if (!node.is_map()) {
    expected("a map from names to values", node, reading);
    return false;
  }
  for (const NodeEntry& entry : node.entries)
    if (entry.key.empty()) add_finding(entry.where, reading, "expected a name, found none");
  return has_enough(node.entries.size(), at_least, node, reading);
}

std::string entry_context(const std::string& parameter, const std::string& key) {
  std::string one = parameter.substr(parameter.rfind('.') + 1);
  if (one.ends_with("ies"))
    one.replace(one.size() - 3, 3, "y");
  else if (one.ends_with("s"))
    one.pop_back();
  return one + " '" + key + "'";
}

Kind<bool> boolean_kind() {
  auto read = [](const Node& node, const Reading& reading) -> std::optional<bool> {
    if (node.is_scalar() && !node.quoted && (node.text == "true" || node.text == "false"))
      return node.text == "true";
    expected("true or false", node, reading);
    return {};
  };
  return {{.form = KindInfo::Form::boolean}, read, &Node::boolean};
}

Node echo_text(const std::string& text) {
  Node node = Node::scalar(text);
  const bool is_word = std::any_of(text.begin(), text.begin() + (text.empty() ? 0 : 1),
                                   [](unsigned char c) { return std::isalpha(c) || c == '/'; });
  const std::string reserved[] = {"true", "false", "yes", "no", "on", "off", "y", "n"};
  node.quoted = !is_word || std::count(std::begin(reserved), std::end(reserved), text) > 0;
  return node;
}

Kind<std::string> text_kind() { return {{.form = KindInfo::Form::text}, read_text, echo_text}; }

Kind<std::filesystem::path> file_kind(bool must_exist) {
  auto read = [must_exist](const Node& node, const Reading& reading) -> std::optional<std::filesystem::path> {
    const auto text = read_text(node, reading);
    if (!text) return {};
    if (text->empty() || text->find('\0') != std::string::npos) {
      expected("a file name", node, reading);
      return {};
    }
    const auto path =
        std::filesystem::absolute(ReadingScope::folder_of(node, reading.folder) / *text).lexically_normal();
    std::error_code error;
    if (!must_exist || std::filesystem::exists(path, error)) return path;
    add_finding(node.where, reading, "no such file '" + *text + "' (looked for " + path.string() + ")");
    return {};
  };
  auto echo = [](const std::filesystem::path& path) { return echo_text(path.string()); };
  return {{.form = KindInfo::Form::file}, read, echo};
}

Kind<Node> anything_kind() {
  auto read = [](const Node& node, const Reading&) { return std::optional<Node>(node); };
  return {{.form = KindInfo::Form::anything}, read, [](const Node& node) { return node; }};
}

}  // namespace dda
