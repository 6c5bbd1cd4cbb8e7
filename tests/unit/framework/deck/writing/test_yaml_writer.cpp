#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "framework/deck/document/node.hpp"

namespace dda {
namespace {

Node parse(const std::string& text) { return parse_yaml(text, "a.yaml"); }

TEST(YamlWriter, BlockStyleWithShortListsInLine) {
  const std::string text =
      "a: 1\n"
      "points: [[0, 0], [1, 2.5]]\n"
      "empty: {}\n"
      "none: null\n"
      "list:\n"
      "  - type: x\n"
      "    value: \"3\"\n"
      "  - bonded\n"
      "map:\n"
      "  inner:\n"
      "    deep: [a b, c]\n";
  EXPECT_EQ(to_yaml(parse(text)), text);
}

TEST(YamlWriter, WhatWouldBeMisreadIsQuoted) {
  for (const char* text :
       {"",   "null", "~",  " x", "x ", "a: b", "a #b", "- a",  "---", "a,b", "[", "*a", "&a", "!t",
        "%x", "a\nb", "\"", "'",  "\\", "\t",   "\x01", "\x7f", "é",   "-",   "?", "@x", "`"}) {
    Node root = Node::map();
    root.set("key", Node::scalar(text));
    root.set(std::string("key ") + text, Node::sequence({Node::scalar(text)}));
    EXPECT_TRUE(parse(to_yaml(root)) == root) << to_yaml(root);
  }
}

TEST(YamlWriter, LongListsAreBlocks) {
  Node list = Node::sequence();
  for (int i = 0; i < 40; ++i)
    list.items.push_back(Node::sequence({Node::number(i), Node::number(-1e-12 * i)}));
  Node root = Node::map();
  root.set("outline", list);
  EXPECT_TRUE(parse(to_yaml(root)) == root);
  EXPECT_NE(to_yaml(root).find("\n  - [1, -1.0e-12]\n"), std::string::npos);
}

std::string any_text() {
  return *rc::gen::container<std::string>(
      rc::gen::elementOf(std::string("ab01 :#-[]{}\"'\\\n\t,&*!|>%@?~.")));
}

Node any_node(int depth) {
  const int kind = *rc::gen::inRange(0, depth > 0 ? 4 : 2);
  if (kind == 0) return Node{};
  if (kind == 1) return Node::scalar(any_text());
  Node node = kind == 2 ? Node::sequence() : Node::map();
  const int count = *rc::gen::inRange(0, 4);
  for (int i = 0; i < count; ++i) {
    if (kind == 2) node.items.push_back(any_node(depth - 1));
    if (kind == 3) node.set(any_text(), any_node(depth - 1));
  }
  return node;
}

RC_GTEST_PROP(YamlWriter, EveryTreeRoundTrips, ()) {
  Node root = Node::map();
  root.set("root", any_node(4));
  RC_ASSERT(parse(to_yaml(root)) == root);
}

}  // namespace
}  // namespace dda
