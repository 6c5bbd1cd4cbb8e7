#include <gmock/gmock.h>

#include <map>

#include "framework/deck/kind.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

/// Reads `text` as a value of `kind`; the messages when it is refused.
template <class V>
std::string refusal(const Kind<V>& kind, const std::string& text) {
  return messages([&] {
    Findings findings;
    const Node root = parse_yaml("x: " + text, "a.yaml");
    const bool is_right = kind.read(*root.find("x"), {findings, "/folder", "x", ""}).has_value();
    EXPECT_EQ(is_right, findings.empty());
    findings.throw_if_any();
  });
}

template <class V>
V value(const Kind<V>& kind, const std::string& text) {
  Findings findings;
  const Node root = parse_yaml("x: " + text, "a.yaml");
  auto read = kind.read(*root.find("x"), {findings, "/folder", "x", ""});
  findings.throw_if_any();
  return read.value();
}

TEST(Kind, NumbersInEveryNotation) {
  EXPECT_EQ(value(number_kind(), "3"), 3.0);
  EXPECT_EQ(value(number_kind(), "+3.5"), 3.5);
  EXPECT_EQ(value(number_kind(), "-.5"), -0.5);
  EXPECT_EQ(value(number_kind(), "1e-3"), 1e-3);
  EXPECT_EQ(value(number_kind(), "1.E+3"), 1000.0);
}

TEST(Kind, WhatIsNoNumber) {
  EXPECT_EQ(refusal(number_kind(), "abc"), "a.yaml:1:4: x: expected a number, found 'abc'");
  EXPECT_EQ(refusal(number_kind(), "\"abc\""), "a.yaml:1:4: x: expected a number, found the text 'abc'");
  EXPECT_EQ(refusal(number_kind(), "[3]"), "a.yaml:1:4: x: expected a number, found a list");
  EXPECT_EQ(refusal(number_kind(), "{a: 1}"), "a.yaml:1:4: x: expected a number, found a map");
  EXPECT_THAT(refusal(number_kind(), ""), testing::HasSubstr("expected a number, found nothing"));
  EXPECT_THAT(refusal(number_kind(), "3 MPa"), testing::HasSubstr("numbers carry no unit"));
  EXPECT_THAT(refusal(number_kind(), "3,5"), testing::HasSubstr("expected a number, found '3,5'"));
  EXPECT_THAT(refusal(number_kind(), "+*3"), testing::HasSubstr("expected a number"));
  EXPECT_THAT(refusal(number_kind(), "0x10"), testing::HasSubstr("expected a number"));
}

TEST(Kind, NumbersAreFinite) {
  for (const char* text : {"nan", ".nan", ".NaN", "inf", ".inf", "-.inf", "+.INF", "infinity"})
    EXPECT_THAT(refusal(number_kind(), text), testing::HasSubstr("must be a finite number")) << text;
  EXPECT_THAT(refusal(number_kind(), "1e999"), testing::HasSubstr("too large or too small"));
  for (const char* text : {"1.1e50", "-1e300"})
    EXPECT_THAT(refusal(number_kind(), text), testing::HasSubstr("larger than any quantity")) << text;
  EXPECT_THAT(refusal(number_kind(), "1e-51"), testing::HasSubstr("smaller than any quantity"));
}

TEST(Kind, BoundsAreSaidInWords) {
  EXPECT_EQ(refusal(number_kind({}, between(0, 0.5)), "0.7"),
            "a.yaml:1:4: x: must be between 0 and 0.5, got 0.7");
  EXPECT_EQ(refusal(integer_kind(above(0)), "0"), "a.yaml:1:4: x: must be above 0, got 0");
}

TEST(Kind, IntegersFitTheirType) {
  EXPECT_EQ(value(integer_of<int>({}), "-7"), -7);
  EXPECT_THAT(refusal(integer_of<int>({}), "3000000000"), testing::HasSubstr("3000000000 is out of range"));
  EXPECT_THAT(refusal(integer_of<std::size_t>({}), "-1"), testing::HasSubstr("-1 is out of range"));
  EXPECT_THAT(refusal(integer_of<int>({}), "99999999999999999999"), testing::HasSubstr("out of range"));
  EXPECT_THAT(refusal(integer_of<int>({}), "1.5"), testing::HasSubstr("expected an integer, found '1.5'"));
}

TEST(Kind, BooleansAreTwoWords) {
  EXPECT_TRUE(value(boolean_kind(), "true"));
  EXPECT_FALSE(value(boolean_kind(), "false"));
  EXPECT_THAT(refusal(boolean_kind(), "yes"), testing::HasSubstr("expected true or false, found 'yes'"));
}

TEST(Kind, FilesStartAtTheDecksFolder) {
  EXPECT_EQ(value(file_kind(false), "../mesh.msh"), "/mesh.msh");
  EXPECT_EQ(value(file_kind(false), "/abs.msh"), "/abs.msh");
  EXPECT_EQ(refusal(file_kind(), "a.msh"), "a.yaml:1:4: x: no such file 'a.msh' (looked for /folder/a.msh)");
  EXPECT_THAT(refusal(file_kind(false), "''"), testing::HasSubstr("expected a file name"));
}

TEST(Kind, Points) {
  EXPECT_EQ(value(point_kind(), "[1, -2]"), Vec2(1, -2));
  EXPECT_THAT(refusal(point_kind(), "[1]"), testing::HasSubstr("expected a point [x, y], found a list"));
  EXPECT_EQ(value(spot_kind(), "[1, -2]"), Spot(1, -2));
  EXPECT_EQ(value(spot_kind(), "mid").name, "mid");
  EXPECT_EQ(value(spot_kind(), "\"7\"").name, "7");
  EXPECT_EQ(spot_kind().echo(value(spot_kind(), "\"7\"")).quoted, true);
  EXPECT_THAT(
      refusal(spot_kind(), "7"),
      testing::HasSubstr("expected a point [x, y] or the name of one of the scene's points, found '7'"));
  EXPECT_EQ(refusal(point_kind(), "[a, .nan]"),
            "a.yaml:1:5: x: expected a number, found 'a'\na.yaml:1:8: x: must be a finite number, got .nan");
}

TEST(Kind, ListsNameTheirEntries) {
  EXPECT_EQ(refusal(list_of(number_kind()), "[1, b, 2, d]"),
            "a.yaml:1:8: x.1: expected a number, found 'b'\na.yaml:1:14: x.3: expected a number, found 'd'");
  EXPECT_THAT(refusal(list_of(number_kind(), 2), "[1]"),
              testing::HasSubstr("must have at least 2 entries, got 1"));
  EXPECT_THAT(refusal(list_of(number_kind()), "1"), testing::HasSubstr("expected a list, found '1'"));
}

TEST(Kind, MapsKeepTheOrderOfTheDeck) {
  using Pairs = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(value(map_of<Pairs>(number_kind()), "{b: 1, a: 2}"), (Pairs{{"b", 1}, {"a", 2}}));
  EXPECT_EQ((value(map_of<std::map<std::string, double>>(number_kind()), "{b: 1, a: 2}").at("a")), 2);
}

TEST(Kind, EntriesAreNamedInTheSingular) {
  EXPECT_EQ(entry_context("interfaces", "joint"), "interface 'joint'");
  EXPECT_EQ(entry_context("boundaries", "left"), "boundary 'left'");
  EXPECT_EQ(entry_context("stages.0.loads", "p"), "load 'p'");
}

TEST(Kind, AListOrAWordInItsPlace) {
  const auto kind = list_or_word(number_kind(), "automatic");
  EXPECT_EQ(value(kind, "[1, 2]"), (std::vector<double>{1, 2}));
  EXPECT_TRUE(value(kind, "automatic").empty());
  EXPECT_EQ(kind.echo({}).text, "automatic");
  EXPECT_EQ(kind.echo({1, 2}).items.size(), 2u);
  EXPECT_EQ(kind.info.words(), "`automatic`, or list of: number");
  EXPECT_NE(refusal(kind, "automatc").find("automatic"), std::string::npos);
  EXPECT_FALSE(refusal(kind, "[]").empty());
}

}  // namespace
}  // namespace dda
