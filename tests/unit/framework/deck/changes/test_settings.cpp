#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "framework/deck/changes/settings.hpp"
#include "framework/deck/dimension_of.hpp"
#include "framework/deck/writing/node_json.hpp"
#include "unit/framework/deck/deck_example.hpp"
#include "unit/framework/deck/messages.hpp"
#include "unit/framework/deck/tree_of.hpp"

namespace dda {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Node tree = tree_of("s: {seed: 1, list: [{seed: 2}, {x: {seed: 3}}]}\nseeds: 4");

TEST(Settings, SetsANodeThatKeepsItsPosition) {
  Node root = tree_of("a: {b: 1}");
  set_value(root, "a.c.d", *parse_yaml("v: [1, 2]", "s.yaml").find("v"), {"s.yaml", 7, 3});
  EXPECT_TRUE(root == tree_of("a: {b: 1, c: {d: [1, 2]}}"));
  EXPECT_EQ(to_string(find_value(root, "a.c.d")->where), "s.yaml:1:4");
  EXPECT_EQ(to_string(root.find("a")->entries[1].where), "s.yaml:7:3");
  EXPECT_THAT(messages([&] {
                set_value(root, "a.b.c", Node{}, {"s.yaml", 7, 3});
              }),
              HasSubstr("s.yaml:7:3: the path goes through the value '1'"));
}

TEST(Settings, FindsAPath) {
  EXPECT_EQ(find_value(tree, "s.list.1.x.seed")->text, "3");
  EXPECT_EQ(find_value(tree, "s.list.2"), nullptr);
  EXPECT_EQ(find_value(tree, "s.list.x"), nullptr);
  EXPECT_EQ(find_value(tree, "s.seed.x"), nullptr);
}

TEST(Settings, PathsToAName) {
  EXPECT_THAT(paths_to(tree, "seed"), ElementsAre("s.seed", "s.list.0.seed", "s.list.1.x.seed"));
  EXPECT_TRUE(paths_to(tree, "missing").empty());
}

TEST(Settings, AssignmentSetsTheSameValue) {
  for (const std::string text : {"3", "-0.5", "[1, [2, 3]]", "{a: {b: [1, {c: d}]}, e: ''}", "'3'",
                                 "'a: b, c'", "'null'", "", "{}", "'it''s'", "1e-05"}) {
    const Node value = *tree_of("v: " + text).find("v");
    Node root = tree_of("a: {b: 1}");
    set_value(root, assignment("a.b", value));
    EXPECT_TRUE(*find_value(root, "a.b") == value) << text << " became " << assignment("a.b", value);
    EXPECT_EQ(assignment("a.b", value).find('\n'), std::string::npos);
  }
}

TEST(NodeJson, ScalarsBecomeWhatTheyRead) {
  EXPECT_EQ(to_json(tree_of("{i: 3, n: 0.5, b: true, t: a b, q: '3', z: null, l: [1, {m: x}]}")).dump(),
            R"({"i":3,"n":0.5,"b":true,"t":"a b","q":"3","z":null,"l":[1,{"m":"x"}]})");
  EXPECT_EQ(to_json(tree_of("[1.0e-05, .inf, 1..3, -2]")).dump(), R"([1e-05,".inf","1..3",-2])");
}

TEST(DimensionOf, WalksSectionsMapsListsAndFamilies) {
  const Node root = parse_yaml(example::full_deck, "a.yaml");
  const auto of = [&](const std::string& path) { return dimension_of(example::deck_schema(), root, path); };
  EXPECT_EQ(of("young_modulus"), dimension::stress);
  EXPECT_EQ(of("record.stops.1"), dimension::length);
  EXPECT_EQ(of("curves.crack.0.1"), dimension::length);
  EXPECT_EQ(of("interfaces.joint.law.energy"), dimension::energy_per_area);
  EXPECT_EQ(of("layers.1.strength"), dimension::stress);
  for (const std::string none : {"title", "interfaces", "interfaces.joint.law", "interfaces.bed.law.energy",
                                 "tags.0", "no.such.key", "poisson_ratio", "nox.Direction.Method"})
    EXPECT_EQ(of(none), dimension::none) << none;
}

}  // namespace
}  // namespace dda
