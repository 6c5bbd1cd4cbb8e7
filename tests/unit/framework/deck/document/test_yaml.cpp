#include <gmock/gmock.h>

#include <fstream>

#include "framework/deck/document/node.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Node parse(const std::string& text) { return parse_yaml(text, "a.yaml"); }

std::string refusal(const std::string& text) {
  return messages([&] { parse(text); });
}

TEST(Yaml, EverythingKnowsItsPlace) {
  const Node root = parse("a: 1\nb:\n  - x\n  - {c: 2}\n");
  EXPECT_EQ(to_string(root.where), "a.yaml:1:1");
  EXPECT_EQ(to_string(root.entries[1].where), "a.yaml:2:1");
  EXPECT_EQ(to_string(root.find("a")->where), "a.yaml:1:4");
  EXPECT_EQ(to_string(root.find("b")->items[1].find("c")->where), "a.yaml:4:9");
}

TEST(Yaml, QuotesMakeText) {
  const Node root = parse("a: 1\nb: \"1\"\nc: 'null'\nd: null\ne: !!str 3\nf:\n");
  EXPECT_FALSE(root.find("a")->quoted);
  EXPECT_TRUE(root.find("b")->quoted);
  EXPECT_TRUE(root.find("c")->is_scalar());
  EXPECT_TRUE(root.find("d")->is_null());
  EXPECT_TRUE(root.find("e")->quoted);
  EXPECT_TRUE(root.find("f")->is_null());
}

TEST(Yaml, DuplicateKeyGivesBothPlaces) {
  EXPECT_EQ(refusal("a: 1\nb: 2\na: 3\n"), "a.yaml:3:1: duplicate key 'a', first given at a.yaml:1:1");
  EXPECT_EQ(refusal("a: {b: 1, b: 2}\nc: {d: 1, d: 2}\n"),
            "a.yaml:1:11: duplicate key 'b', first given at a.yaml:1:5\n"
            "a.yaml:2:11: duplicate key 'd', first given at a.yaml:2:5");
}

TEST(Yaml, SyntaxErrorHasItsPlace) {
  EXPECT_THAT(refusal("a: 1\nb: [1, 2\nc: 3\n"), StartsWith("a.yaml:3:"));
  EXPECT_THAT(refusal("a: 1\n\tb: 2\n"), HasSubstr("YAML syntax"));
}

TEST(Yaml, AliasesAreCopied) {
  const Node root = parse("a: &x {b: 1}\nc: *x\n");
  EXPECT_TRUE(*root.find("a") == *root.find("c"));
}

TEST(Yaml, EndlessAliasIsRefused) {
  EXPECT_THAT(refusal("a: &x [1, *x]\n"), HasSubstr("a.yaml:1:11: an alias stands inside what it names"));
}

TEST(Yaml, AliasesOfAliasesAreRefusedBeforeMemoryIsGone) {
  std::string text = "a0: &a0 [1,1,1,1,1,1,1,1,1,1]\n";
  for (int i = 1; i < 12; ++i) {
    const std::string last = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + last;
    for (int j = 0; j < 9; ++j) text += ", " + last;
    text += "]\n";
  }
  EXPECT_THAT(refusal(text), HasSubstr("too large"));
}

TEST(Yaml, DeepNestingIsRefused) {
  EXPECT_THAT(refusal("a: " + std::string(300, '[') + std::string(300, ']')), HasSubstr("nested too deeply"));
}

TEST(Yaml, AliasNeedsItsAnchor) {
  EXPECT_EQ(refusal("a: *x\nb: &x 1\n"), "a.yaml:1:4: nothing is named '&x' before this");
}

TEST(Yaml, StrayCommaIsASyntaxError) {
  EXPECT_THAT(refusal(","), StartsWith("a.yaml:1:1: YAML syntax: "));
  EXPECT_THAT(refusal("!t ,"), HasSubstr("a.yaml:1:"));
}

TEST(Yaml, CharactersThatAreNoneHaveTheirLine) {
  EXPECT_THAT(refusal("a: 1\nb: \xff\n"), StartsWith("a.yaml:2:1: YAML syntax: "));
}

TEST(Yaml, NothingIsNull) {
  const Node root = parse("{a: , b: ~, c: null, d: \"null\", e: ''}");
  for (const char* key : {"a", "b", "c"}) EXPECT_TRUE(root.find(key)->is_null()) << key;
  for (const char* key : {"d", "e"}) EXPECT_TRUE(root.find(key)->is_scalar()) << key;
}

TEST(Yaml, OneDocumentOnly) { EXPECT_THAT(refusal("a: 1\n---\nb: 2\n"), HasSubstr("only one document")); }

TEST(Yaml, EmptyDocumentIsAnEmptyMap) {
  EXPECT_TRUE(parse("").is_map());
  EXPECT_TRUE(parse("# nothing\n").is_map());
}

TEST(Yaml, KeysArePlainNames) {
  EXPECT_THAT(refusal("{[1, 2]: 3}\n"), HasSubstr("a key must be a plain name"));
}

TEST(Yaml, FilesThatCannotBeRead) {
  EXPECT_EQ(messages([] { read_yaml("no/such.yaml"); }), "no/such.yaml: no such file");
  EXPECT_THAT(messages([] { read_yaml("/"); }), HasSubstr("is a folder"));
  EXPECT_THAT(messages([] { read_yaml("/dev/zero"); }), HasSubstr("is a device"));
}

TEST(Yaml, ByteOrderMarkIsNotPartOfTheText) {
  EXPECT_EQ(parse_yaml("\xEF\xBB\xBF"
                       "a: 1\n",
                       "a.yaml")
                .find("a")
                ->text,
            "1");
}

TEST(Yaml, FileNamesPositions) {
  const std::string path = testing::TempDir() + "dda_test_yaml.yaml";
  std::ofstream(path) << "a: 1\n";
  EXPECT_EQ(to_string(read_yaml(path).find("a")->where), path + ":1:4");
}

}  // namespace
}  // namespace dda
