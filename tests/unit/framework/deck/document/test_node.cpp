#include <gmock/gmock.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "framework/deck/document/node.hpp"

namespace dda {
namespace {

TEST(Node, SetKeepsOrderAndReplaces) {
  Node node;
  node.set("b", Node::integer(1));
  node.set("a", Node::integer(2));
  node.set("b", Node::integer(3));
  ASSERT_EQ(node.entries.size(), 2u);
  EXPECT_EQ(node.entries[0].key, "b");
  EXPECT_EQ(node.find("b")->text, "3");
  EXPECT_EQ(node.find("c"), nullptr);
}

TEST(Node, NumbersAreShort) {
  EXPECT_EQ(Node::number(0.1).text, "0.1");
  EXPECT_EQ(Node::number(30000).text, "30000");
  EXPECT_EQ(Node::number(2.4e-9).text, "2.4e-09");
  EXPECT_EQ(Node::number(1e-5).text, "1.0e-05");
}

RC_GTEST_PROP(Node, NumbersReadBackToTheSameBits, (std::uint64_t bits)) {
  double value = 0;
  std::memcpy(&value, &bits, sizeof value);
  RC_PRE(std::isfinite(value));
  const double back = std::strtod(Node::number(value).text.c_str(), nullptr);
  RC_ASSERT(std::memcmp(&back, &value, sizeof value) == 0);
}

TEST(Node, EqualityIgnoresPositionsAndQuotes) {
  Node a = Node::scalar("x"), b = Node::scalar("x");
  a.where = {"file", 1, 2};
  b.quoted = true;
  EXPECT_TRUE(a == b);
  EXPECT_FALSE(a == Node::scalar("y"));
  EXPECT_FALSE(Node::sequence({a}) == Node::sequence({a, b}));
  EXPECT_FALSE(Node::map() == Node::sequence());
}

}  // namespace
}  // namespace dda
