#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "framework/deck/expression/reading_scope.hpp"
#include "framework/deck/expression/variables.hpp"
#include "framework/deck/messages.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using testing::HasSubstr;

/// `x` of a deck, as a number, and what its variables come to.
class DeckOfNumbers {
 public:
  explicit DeckOfNumbers(const std::string& text) : root_(parse_yaml(text, "a.yaml")) {}

  double number() { return read(number_kind()); }
  template <class V>
  V read(const Kind<V>& kind) {
    Findings findings;
    const Node* section = root_.find("variables");
    Variables variables(section ? *section : Node(), findings);
    values_ = variables.values();
    const std::set<std::string> bases;
    const ReadingScope scope(variables, bases);
    auto out = kind.read(*root_.find("x"), {findings, "/folder", "x", ""});
    if (findings.empty()) variables.refuse_unused({}, findings);
    findings.throw_if_any();
    return out.value();
  }
  double value(const std::string& name) const { return values_.at(name); }

 private:
  Node root_;
  std::map<std::string, double> values_;
};

double number(const std::string& text) { return DeckOfNumbers(text).number(); }
std::string refusal(const std::string& text) {
  return messages([&] { number(text); });
}

TEST(Expressions, AreArithmetic) {
  EXPECT_EQ(number("x: 2*3 + 4"), 10);
  EXPECT_EQ(number("x: -2.5*4"), -10);
  EXPECT_EQ(number("x: (1 + 2)*3 - 4/8"), 8.5);
  EXPECT_EQ(number("x: 2^3^2"), 512);
  EXPECT_EQ(number("x: -2^2"), -4);
  EXPECT_EQ(number("x: 1e-3*1E+3"), 1);
  EXPECT_EQ(number("x: \"2 < 3 ? 5 : 6\""), 5);
}

TEST(Expressions, HaveFunctionsAndPi) {
  EXPECT_DOUBLE_EQ(number("x: sqrt(2)"), std::sqrt(2));
  EXPECT_DOUBLE_EQ(number("x: sin(pi/6)"), 0.5);
  EXPECT_EQ(number("x: pi"), std::numbers::pi);
  EXPECT_EQ(number("x: \"min(3, 2) + max(3, 2)\""), 5);
  EXPECT_EQ(number("x: floor(2.7) + ceil(2.2) + rint(1.6)"), 7);
  EXPECT_DOUBLE_EQ(number("x: log(exp(2)) + log10(100)"), 4);
}

TEST(Expressions, QuotesMayStandAroundThem) {
  EXPECT_EQ(number("x: '3'"), 3);
  EXPECT_EQ(number("x: \"3*2\""), 6);
}

TEST(Expressions, IntegersMayBeComputedButForRoundOff) {
  EXPECT_EQ(DeckOfNumbers("{variables: {h: 0.3, s: 0.1}, x: h/s}").read(integer_kind()), 3);
  EXPECT_EQ(messages([] { DeckOfNumbers("{variables: {h: 0.35}, x: h/0.1}").read(integer_kind()); }),
            "a.yaml:1:27: x: expected an integer, found h/0.1, which is 3.5");
}

TEST(Variables, MayUseEachOtherInAnyOrder) {
  DeckOfNumbers deck("variables: {a0: D/6, D: 2*R, R: 30}\nx: a0 + D");
  EXPECT_EQ(deck.number(), 70);
  EXPECT_EQ(deck.value("a0"), 10);
  EXPECT_EQ(deck.value("D"), 60);
}

TEST(Variables, StandInPointsAndLists) {
  const std::string deck = "variables: {D: 10}\n";
  EXPECT_EQ(DeckOfNumbers(deck + "x: [-D/2, 3]").read(point_kind()), Vec2(-5, 3));
  EXPECT_EQ(DeckOfNumbers(deck + "x: [D, 2*D]").read(list_of(number_kind())), (std::vector<double>{10, 20}));
}

TEST(Variables, AreNotPutIntoTexts) {
  EXPECT_EQ(messages([] { DeckOfNumbers("variables: {D: 10}\nx: D").read(text_kind()); }),
            "a.yaml:1:13: variables: 'D' is used nowhere");
}

TEST(Variables, CirclesAreToldOnceWithTheirWay) {
  EXPECT_EQ(refusal("variables: {a: b + 1, b: 2*c, c: a}\nx: a"),
            "a.yaml:1:13: variables: a → b → c → a is a circle");
  EXPECT_EQ(refusal("variables: {a: a + 1}\nx: a"), "a.yaml:1:13: variables: a → a is a circle");
}

TEST(Variables, UnknownNamesAreToldWhereTheyStand) {
  EXPECT_EQ(refusal("variables: {depth: 100}\nx: 2*(detph + 1)"),
            "a.yaml:2:7: x: expected a number, found '2*(detph + 1)': 'detph' is no variable; did you mean "
            "'depth'?");
  EXPECT_EQ(refusal("variables: {depth: 100}\nx: \"depth + sqr(2)\""),
            "a.yaml:2:13: x: expected a number, found the text 'depth + sqr(2)': 'sqr' is no function; did "
            "you mean "
            "'sqrt'?");
  EXPECT_EQ(refusal("variables: {D: 100, a: Dd/6}\nx: a + D"),
            "a.yaml:1:24: variables.a: 'Dd' is no variable; did you mean 'D'?");
}

TEST(Variables, MayBeMeantByTheOtherCase) {
  EXPECT_THAT(refusal("variables: {B: 1, H: 2}\nx: h/2 + B + H"),
              HasSubstr("'h' is no variable; did you mean 'H'?"));
}

TEST(Variables, ThatNothingUsesAreRefused) {
  EXPECT_EQ(refusal("variables: {depth: 1, dephts: 2}\nx: depth"),
            "a.yaml:1:23: variables: 'dephts' is used nowhere; did you mean 'depth'?");
  Findings findings;
  Variables variables(*parse_yaml("v: {a: 1}", "a.yaml").find("v"), findings);
  variables.refuse_unused({"a"}, findings);
  EXPECT_TRUE(findings.empty()) << "what a setting has replaced has used it";
}

TEST(Variables, HaveNamesThatExpressionsCanSpeakOf) {
  EXPECT_THAT(refusal("variables: {a-b: 1}\nx: 1"), HasSubstr("1:13: variables: 'a-b' is no name"));
  EXPECT_THAT(refusal("variables: {pi: 3}\nx: pi"), HasSubstr("'pi' is a constant of expressions"));
  EXPECT_THAT(refusal("variables: {sin: 3}\nx: 1"), HasSubstr("'sin' is a function of expressions"));
  EXPECT_THAT(refusal("variables: [1]\nx: 1"), HasSubstr("expected a map from names"));
  EXPECT_THAT(refusal("variables: {a: [1]}\nx: a"),
              HasSubstr("variables.a: expected a number or an expression"));
}

TEST(Expressions, WhatIsWrongIsTold) {
  EXPECT_THAT(refusal("x: 2*(3 + 1"), HasSubstr("x: expected a number, found '2*(3 + 1'"));
  EXPECT_THAT(refusal("x: 2**3"),
              HasSubstr("a.yaml:1:5: x: expected a number, found '2**3': powers are written with ^"));
  EXPECT_THAT(refusal("x: 3,5"), HasSubstr("the decimal sign is a point"));
  EXPECT_THAT(refusal("x: a = 3"), HasSubstr("nothing is assigned"));
  EXPECT_THAT(refusal("x: 1/0"), HasSubstr("must be a finite number, 1/0, which is inf"));
  EXPECT_THAT(refusal("x: sqrt(-1)"), HasSubstr("must be a finite number"));
  EXPECT_THAT(refusal("x: 3 MPa"), HasSubstr("numbers carry no unit"));
  EXPECT_THAT(refusal("x: 1e30*1e30"), HasSubstr("larger than any quantity"));
  EXPECT_THAT(refusal("variables: {a: 1/0}\nx: a"), HasSubstr("variables.a: '1/0' is no finite number"));
  EXPECT_THAT(refusal("x: \"''\""), HasSubstr("expected a number"));
}

TEST(Expressions, BoundsAreThoseOfTheValue) {
  EXPECT_EQ(messages([] { DeckOfNumbers("{variables: {D: 3}, x: 1 - D}").read(number_kind({}, above(0))); }),
            "a.yaml:1:24: x: must be above 0, got 1 - D, which is -2");
}

TEST(Names, AreWordsThatAreNoNumbers) {
  std::vector<std::string> names;
  for (const NameInText& found : names_in("2e3*rho + 1.e-5*g1 - x2/3.5E+2e")) names.push_back(found.name);
  EXPECT_THAT(names, testing::ElementsAre("rho", "g1", "x2", "e"));
}

}  // namespace
}  // namespace dda
