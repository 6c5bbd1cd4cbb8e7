#include <gmock/gmock.h>

#include "framework/deck/document/node.hpp"
#include "unit/framework/deck/messages.hpp"
#include "unit/framework/deck/tree_of.hpp"

namespace dda {
namespace {

using testing::HasSubstr;

Node after(const std::string& text, const std::string& assignment) {
  Node root = parse_yaml(text, "a.yaml");
  set_value(root, assignment);
  return root;
}

std::string refusal(const std::string& text, const std::string& assignment) {
  return messages([&] { after(text, assignment); });
}

TEST(SetValue, ReplacesAValue) {
  EXPECT_TRUE(after("a: {b: 1, c: 2}", "a.b=5") == tree_of("a: {b: 5, c: 2}"));
  EXPECT_TRUE(after("a: {b: 1}", "a=[1, {x: 2}]") == tree_of("a: [1, {x: 2}]"));
  EXPECT_TRUE(after("a: 1", "a=") == tree_of("a:"));
  EXPECT_TRUE(after("a: 1", "a=x=y") == tree_of("a: x=y"));
}

TEST(SetValue, WalksListsByNumber) {
  EXPECT_TRUE(after("s: [{l: [{f: 1}, {f: 2}]}]", "s.0.l.1.f=7") == tree_of("s: [{l: [{f: 1}, {f: 7}]}]"));
}

TEST(SetValue, CreatesMissingMaps) {
  EXPECT_TRUE(after("", "path.control.type=arc_length") == tree_of("path: {control: {type: arc_length}}"));
  EXPECT_TRUE(after("path:\n", "path.steps=3") == tree_of("path: {steps: 3}"));
}

TEST(SetValue, PositionIsTheCommandLine) {
  const Node root = after("a: 1", "b.c=[1, 2]");
  EXPECT_EQ(to_string(root.find("b")->find("c")->items[0].where), "--set b.c");
  EXPECT_EQ(to_string(root.find("b")->where), "--set b.c");
  EXPECT_EQ(to_string(root.where), "a.yaml:1:1");
}

TEST(SetValue, RefusesWhatHasNoMeaning) {
  EXPECT_THAT(refusal("a: 1", "a.b=2"), HasSubstr("--set a.b: the path goes through the value '1'"));
  EXPECT_THAT(refusal("a: [1]", "a.1=2"), HasSubstr("'1' is not an entry of the list"));
  EXPECT_THAT(refusal("a: [1]", "a.x=2"), HasSubstr("'x' is not an entry of the list"));
  EXPECT_THAT(refusal("a: 1", "a"), HasSubstr("expected path.to.key=value"));
  EXPECT_THAT(refusal("a: 1", "a..b=1"), HasSubstr("empty name"));
  EXPECT_THAT(refusal("a: 1", "=1"), HasSubstr("empty name"));
  EXPECT_THAT(refusal("a: 1", "a=[1"), HasSubstr("--set a"));
}

}  // namespace
}  // namespace dda
