#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "framework/deck/changes/extended.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class Extended : public testing::Test {
 protected:
  Extended() : folder_(fs::path(testing::TempDir()) / ("extended" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "below");
  }
  ~Extended() override { fs::remove_all(folder_); }

  fs::path put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  ExtendedNode read(const std::string& name) const { return extended(read_yaml(folder_ / name)); }
  std::string yaml(const std::string& name) const { return to_yaml(read(name).root); }
  std::string refusal(const std::string& name) const {
    return messages([&] { read(name); });
  }

 private:
  fs::path folder_;
};

TEST_F(Extended, KeysAddUpAndListsAreReplaced) {
  put("base.yaml", "a: 1\nm: {x: 1, y: {z: 2, w: 3}}\nl: [1, 2, 3]\n");
  put("deck.yaml", "extends: base.yaml\nm: {y: {w: 4, v: 5}}\nl: [9]\nn: 6\n");
  EXPECT_EQ(read("deck.yaml").root,
            parse_yaml("{a: 1, m: {x: 1, y: {z: 2, w: 4, v: 5}}, l: [9], n: 6}", "b"));
}

TEST_F(Extended, AnotherTypeReplacesTheWholeMap) {
  put("base.yaml", "law: {type: linear, strength: 3, energy: 1}\nsame: {type: a, x: 1}\nword: bonded\n");
  put("deck.yaml",
      "extends: base.yaml\nlaw: {type: friction, angle: 30}\nsame: {type: a, y: 2}\nword: {type: a}\n");
  EXPECT_EQ(
      read("deck.yaml").root,
      parse_yaml("{law: {type: friction, angle: 30}, same: {type: a, x: 1, y: 2}, word: {type: a}}", "b"));
}

TEST_F(Extended, DecksMayBeBuiltOnDecksInOtherFolders) {
  put("root.yaml", "a: 1\nb: 1\nc: 1\n");
  put("below/middle.yaml", "extends: ../root.yaml\nb: 2\nc: 2\n");
  put("deck.yaml", "extends: below/middle.yaml\nc: 3\n");
  const ExtendedNode found = read("deck.yaml");
  EXPECT_EQ(found.root, parse_yaml("{a: 1, b: 2, c: 3}", "x"));
  EXPECT_EQ(found.bases.size(), 2u);
  EXPECT_THAT(found.root.find("a")->where.file, testing::EndsWith("root.yaml"));
  EXPECT_THAT(found.root.find("b")->where.file, testing::EndsWith("middle.yaml"));
  EXPECT_THAT(found.root.find("c")->where.file, testing::EndsWith("deck.yaml"));
  EXPECT_EQ(found.root.find("c")->where.line, 2);
  EXPECT_THAT(found.root.where.file, testing::EndsWith("deck.yaml"));
}

TEST_F(Extended, NamesThatAreReplacedAreKept) {
  put("base.yaml", "a: 2*D\nl: [E, {x: F}]\nk: G\n");
  put("deck.yaml", "extends: base.yaml\na: 1\nl: []\n");
  EXPECT_THAT(read("deck.yaml").replaced, testing::UnorderedElementsAre("D", "E", "F"));
}

TEST_F(Extended, NullDropsWhatIsInherited) {
  put("base.yaml", "supports: {left: {fix: x, at: D}, right: {fix: y}}\nmotion: {time: 1}\n");
  put("deck.yaml", "extends: base.yaml\nsupports: {left: null, new: null}\nmotion:\n");
  const ExtendedNode found = read("deck.yaml");
  EXPECT_EQ(found.root, parse_yaml("{supports: {right: {fix: y}, new: null}}", "b"));
  EXPECT_THAT(found.replaced, testing::IsSupersetOf({"D"}));
}

TEST_F(Extended, ADeckAloneStaysAsItIs) {
  put("deck.yaml", "a: 1\n");
  EXPECT_EQ(yaml("deck.yaml"), "a: 1\n");
  EXPECT_TRUE(read("deck.yaml").bases.empty());
}

TEST_F(Extended, WhatCannotBeIsToldAtItsPlace) {
  put("missing.yaml", "a: 1\nextends: bsae.yaml\n");
  EXPECT_THAT(refusal("missing.yaml"),
              HasSubstr("missing.yaml:2:10: extends: no such file 'bsae.yaml' (looked for /"));
  put("list.yaml", "extends: [a.yaml]\n");
  EXPECT_THAT(refusal("list.yaml"), HasSubstr("list.yaml:1:10: extends: expected the name of the deck"));
  put("one.yaml", "extends: two.yaml\n");
  put("two.yaml", "extends: one.yaml\n");
  EXPECT_THAT(refusal("one.yaml"), HasSubstr("two.yaml:1:10: extends: "));
  EXPECT_THAT(refusal("one.yaml"), HasSubstr("is built on this deck itself"));
  put("broken.yaml", "a: [1\n");
  put("on_broken.yaml", "extends: broken.yaml\n");
  EXPECT_THAT(refusal("on_broken.yaml"), HasSubstr("broken.yaml:2:1: YAML syntax"));
}

}  // namespace
}  // namespace dda
