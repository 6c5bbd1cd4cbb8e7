#include "framework/deck/document/node.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

namespace dda {

Node::Node() = default;
Node::Node(const Node&) = default;
Node::Node(Node&&) noexcept = default;
Node& Node::operator=(const Node&) = default;
Node& Node::operator=(Node&&) noexcept = default;
Node::~Node() = default;

const Node* Node::find(std::string_view key) const {
  auto found = std::find_if(entries.begin(), entries.end(), [&](const NodeEntry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

Node* Node::find(std::string_view key) { return const_cast<Node*>(std::as_const(*this).find(key)); }

void Node::set(const std::string& key, Node value) {
  kind = Kind::map;
  if (Node* old = find(key)) {
    *old = std::move(value);
    return;
  }
  entries.push_back({key, value.where, std::move(value)});
}

Node Node::scalar(std::string text) {
  Node node;
  node.kind = Kind::scalar;
  node.text = std::move(text);
  return node;
}

Node Node::number(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  std::string text(buffer, end);
  // Readers of YAML 1.1 (PyYAML) take "1e-05" for a text and "1.0e-05" for a number.
  const auto exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return scalar(std::move(text));
}

Node Node::integer(std::int64_t value) { return scalar(std::to_string(value)); }

Node Node::boolean(bool value) { return scalar(value ? "true" : "false"); }

Node Node::sequence(std::vector<Node> items) {
  Node node;
  node.kind = Kind::sequence;
  node.items = std::move(items);
  return node;
}

Node Node::map() {
  Node node;
  node.kind = Kind::map;
  return node;
}

bool operator==(const Node& a, const Node& b) {
  auto same_entry = [](const NodeEntry& x, const NodeEntry& y) {
    return x.key == y.key && x.value == y.value;
  };
  return a.kind == b.kind && a.text == b.text && a.items == b.items &&
         std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(), same_entry);
}

}  // namespace dda
