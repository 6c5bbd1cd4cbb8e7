#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "framework/base/errors.hpp"

namespace dda {

struct NodeEntry;

/// A piece of a deck: a tree of texts, lists and ordered maps in which everything knows its Position.
///
/// Scalars stay text until a Schema reads them, so that the message of a wrong value can quote it.
struct Node {
  enum class Kind { null, scalar, sequence, map };

  Kind kind = Kind::null;
  Position where;
  std::string text;                ///< of a scalar
  bool quoted = false;             ///< a quoted scalar is text even if it looks like a number
  std::vector<Node> items;         ///< of a sequence
  std::vector<NodeEntry> entries;  ///< of a map, in the order of the file; keys are unique

  // Defined where NodeEntry is complete: a node holds entries, an entry holds a node.
  Node();
  Node(const Node&);
  Node(Node&&) noexcept;
  Node& operator=(const Node&);
  Node& operator=(Node&&) noexcept;
  ~Node();

  bool is_null() const { return kind == Kind::null; }
  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_sequence() const { return kind == Kind::sequence; }
  bool is_map() const { return kind == Kind::map; }

  /// The value of a key of this map; nullptr when there is none or this is no map.
  const Node* find(std::string_view key) const;
  Node* find(std::string_view key);
  /// Adds or replaces the value of a key; makes a map of a null.
  void set(const std::string& key, Node value);

  static Node scalar(std::string text);
  static Node number(double value);  ///< shortest text that reads back to the same bits
  static Node integer(std::int64_t value);
  static Node boolean(bool value);
  static Node sequence(std::vector<Node> items = {});
  static Node map();
};

/// One key of a map, where the key stands, and its value.
struct NodeEntry {
  std::string key;
  Position where;
  Node value;
};

/// Same content; positions and quotes are not compared.
bool operator==(const Node& a, const Node& b);

/// Reads a YAML file. InputError with position: no such file, syntax, a duplicate key (both places), a cyclic
/// alias.
Node read_yaml(const std::filesystem::path& path);

/// Reads YAML text; `file_name` is what positions say. An empty document is an empty map.
Node parse_yaml(const std::string& text, const std::string& file_name);

/// Block style, short lists in one line, order kept; parse_yaml(to_yaml(node)) == node.
std::string to_yaml(const Node& node);

/// Applies "path.to.key=value" (value in YAML, entries of a list by number from 0), creating missing maps.
///
/// Positions of what is set read "<origin> path.to.key". InputError when there is no '=', a name of the path
/// is empty, the path goes through a scalar, or a number is outside its list.
void set_value(Node& root, const std::string& assignment, const std::string& origin = "--set");

}  // namespace dda
