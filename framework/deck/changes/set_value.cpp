#include <charconv>
#include <optional>

#include "framework/deck/changes/settings.hpp"

namespace dda {

namespace {

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> names(1);
  for (char c : path) {
    if (c == '.')
      names.emplace_back();
    else
      names.back() += c;
  }
  return names;
}

std::optional<std::size_t> as_index(const std::string& name) {
  std::size_t index = 0;
  const char* end = name.data() + name.size();
  const auto result = std::from_chars(name.data(), end, index);
  return result.ec == std::errc() && result.ptr == end ? std::optional(index) : std::nullopt;
}

/// Lines and columns of a command line mean nothing: only the path is kept.
void place(Node& node, const Position& where) {
  node.where = where;
  for (Node& item : node.items) place(item, where);
  for (NodeEntry& entry : node.entries) {
    entry.where = where;
    place(entry.value, where);
  }
}

Node& list_item(Node& list, const std::string& name, const Position& where) {
  const auto index = as_index(name);
  if (!index || *index >= list.items.size())
    throw InputError(where, "'" + name + "' is not an entry of the list; it has " +
                                std::to_string(list.items.size()) + " entries, counted from 0");
  return list.items[*index];
}

/// The child of a node on the path, made when missing.
Node& descend(Node& node, const std::string& name, const Position& where) {
  if (name.empty()) throw InputError(where, "the path has an empty name");
  if (node.is_sequence()) return list_item(node, name, where);
  if (node.is_scalar()) throw InputError(where, "the path goes through the value '" + node.text + "'");
  if (node.is_null()) node.where = where;
  if (!node.find(name)) {
    Node missing;
    missing.where = where;
    node.set(name, std::move(missing));
  }
  return *node.find(name);
}

const Node* child(const Node& node, const std::string& name) {
  if (!node.is_sequence()) return node.find(name);
  const auto index = as_index(name);
  return index && *index < node.items.size() ? &node.items[*index] : nullptr;
}

void collect(const Node& node, const std::string& name, const std::string& prefix,
             std::vector<std::string>& found) {
  for (std::size_t i = 0; i < node.items.size(); ++i)
    collect(node.items[i], name, prefix + std::to_string(i) + ".", found);
  for (const NodeEntry& entry : node.entries) {
    if (entry.key == name) found.push_back(prefix + entry.key);
    collect(entry.value, name, prefix + entry.key + ".", found);
  }
}

}  // namespace

void set_value(Node& root, const std::string& path, Node value, const Position& where) {
  Node* target = &root;
  for (const std::string& name : split(path)) target = &descend(*target, name, where);
  *target = std::move(value);
}

const Node* find_value(const Node& root, const std::string& path) {
  const Node* node = &root;
  for (const std::string& name : split(path))
    if (node) node = child(*node, name);
  return node;
}

std::string assignment(const std::string& path, const Node& value) {
  return path + "=" + to_flow_yaml(value);
}

std::vector<std::string> paths_to(const Node& root, const std::string& name) {
  std::vector<std::string> found;
  collect(root, name, "", found);
  return found;
}

void set_value(Node& root, const std::string& assignment, const std::string& origin) {
  const auto equals = assignment.find('=');
  const std::string path = assignment.substr(0, equals);
  const Position where{origin + " " + path, 0, 0};
  if (equals == std::string::npos) throw InputError(where, "expected path.to.key=value");
  const std::string text = assignment.substr(equals + 1);
  Node value;
  if (text.find_first_not_of(" \t\r\n") != std::string::npos) value = parse_yaml(text, where.file);
  place(value, where);
  set_value(root, path, std::move(value), where);
}

}  // namespace dda
