#pragma once

#include <string>
#include <vector>

#include "framework/deck/document/node.hpp"

namespace dda {

// What `--set path.to.key=value` does, on trees: `path` is such a dotted path.

/// set_value with the value as a node, which keeps its position; what is created on the way stands at
/// `where`.
void set_value(Node& root, const std::string& path, Node value, const Position& where);

/// What a path leads to; nullptr when there is nothing.
const Node* find_value(const Node& root, const std::string& path);

/// Paths of every entry of that name, however deep, in the order of the tree.
std::vector<std::string> paths_to(const Node& root, const std::string& name);

/// "path=value", the value in flow style: set_value(root, assignment(path, value)) sets that path to that
/// value.
std::string assignment(const std::string& path, const Node& value);

/// One line: `3`, `[1, 2]`, `{type: voronoi, seed: 3}`; "" for nothing.
std::string to_flow_yaml(const Node& node);

}  // namespace dda
