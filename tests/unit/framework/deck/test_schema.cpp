#include <gmock/gmock.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <map>
#include <string>

#include "framework/deck/schema.hpp"
#include "unit/framework/deck/deck_example.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using namespace example;
using testing::HasSubstr;

Deck read(const std::string& text) { return deck_schema().read(parse_yaml(text, "beam.yaml")); }

std::string refusal(const std::string& text) {
  return messages([&] { read(text); });
}

TEST(Schema, ReadsEveryKind) {
  const Deck deck = read(full_deck);
  EXPECT_EQ(deck.title, "12");
  EXPECT_EQ(deck.density, 2.4e-9);
  EXPECT_EQ(deck.state, State::strain);
  EXPECT_EQ(deck.mesh, std::filesystem::absolute("meshes/beam.msh"));
  EXPECT_EQ(deck.origin, Vec2(1, -2.5));
  EXPECT_EQ(deck.curves.at("crack")[1], Vec2(0, 10));
  EXPECT_EQ(deck.tags, (std::vector<std::string>{"fine", "true", "with: colon"}));
  EXPECT_EQ(deck.record.every, 5);
  EXPECT_EQ(deck.record.stops, (std::vector<double>{0.1, 0.2}));
  ASSERT_EQ(deck.interfaces.size(), 2u);
  EXPECT_EQ(deck.interfaces[0].first, "joint");
  EXPECT_EQ(deck.interfaces[0].second.thickness, 100);
  EXPECT_EQ(deck.layers[1].name(), "softening");
  EXPECT_EQ(deck.nox.find("Direction")->find("Method")->text, "Newton");
}

TEST(Schema, DefaultsComeFromTheDeclaration) {
  const Deck deck = read("young_modulus: 1\ninterfaces: {joint: {}}\n");
  EXPECT_EQ(deck.title, "untitled");
  EXPECT_EQ(deck.poisson_ratio, 0.2);
  EXPECT_FALSE(deck.density.has_value());
  EXPECT_EQ(deck.record.every, 10);
  EXPECT_TRUE(deck.curves.empty());
  EXPECT_TRUE(deck.nox.is_null());
  EXPECT_EQ(deck.interfaces[0].second.law.name(), "bonded");
}

TEST(Schema, StructsKnowTheirPlace) {
  const Deck deck = read(full_deck);
  EXPECT_EQ(to_string(deck.where), "beam.yaml:2:1");
  EXPECT_EQ(to_string(deck.interfaces[0].second.where), "beam.yaml:15:5")
      << "a block map stands at its first key";
}

TEST(Schema, UnknownParameterIsSuggested) {
  EXPECT_EQ(refusal("young_modulus: 1\ninterfaces:\n  joint:\n    thikness: 2\n"),
            "beam.yaml:4:5: unknown parameter 'thikness' in interface 'joint'; did you mean 'thickness'?");
  EXPECT_EQ(
      refusal("young_modulus: 1\nrecord: {colour: 2}\n"),
      "beam.yaml:2:10: unknown parameter 'colour' in section 'record'; known are every, fields and stops");
}

/// Where a path ends: users write the gauge beside the other goals.
TEST(Schema, NumbersThatBelongIntoAMapAreSentThere) {
  struct Goals {
    double load = 0;
    std::map<std::string, double> gauges;
  };
  const auto schema =
      Schema<Goals>("Goals.")
          .number("load", &Goals::load, {.fallback = 0.0, .text = "A load."})
          .map("gauges", &Goals::gauges, number_kind(), {.fallback = {{}}, .text = "By name."});
  const auto said = [&](const char* text) {
    return messages([&] { schema.read(parse_yaml(text, "d.yaml")); });
  };
  EXPECT_EQ(said("drift: 3"),
            "d.yaml:1:1: unknown parameter 'drift'; known are load and gauges; or `gauges: {drift: ...}`");
  EXPECT_EQ(said("gauge: 3"), "d.yaml:1:1: unknown parameter 'gauge'; did you mean 'gauges'?");
  EXPECT_EQ(said("drift: [3]"), "d.yaml:1:1: unknown parameter 'drift'; known are load and gauges");
}

TEST(Schema, MissingParameterSaysWhatItIs) {
  EXPECT_EQ(refusal("title: x\n"),
            "beam.yaml:1:1: missing parameter 'young_modulus' (number in F/L², above 0)");
}

TEST(Schema, EverythingWrongIsSaidAtOnce) {
  EXPECT_EQ(
      refusal("young_modulus: -1\npoisson_ratio: 0.7\nstate: plane_stres\nrecord: {every: 0, fields: maybe}\n"
              "origin: 3\nlayers: [bonded, soften]\n"),
      "beam.yaml:1:16: young_modulus: must be above 0, got -1\n"
      "beam.yaml:2:16: poisson_ratio: must be between 0 and 0.5, got 0.7\n"
      "beam.yaml:3:8: state: unknown value 'plane_stres'; did you mean 'plane_stress'?\n"
      "beam.yaml:4:17: every: must be at least 1, got 0\n"
      "beam.yaml:4:28: fields: expected true or false, found 'maybe'\n"
      "beam.yaml:5:9: origin: expected a point [x, y], found '3'\n"
      "beam.yaml:6:18: unknown test_law 'soften'; known are bonded and softening");
}

TEST(Schema, WrongShapes) {
  EXPECT_THAT(refusal("[1, 2]"), HasSubstr("expected a map of parameters, found a list"));
  EXPECT_THAT(refusal("young_modulus: 1\nrecord: 3\n"),
              HasSubstr("record: expected a map of parameters, found '3'"));
  EXPECT_THAT(refusal("young_modulus: 1\nrecord:\n"),
              HasSubstr("record: expected a map of parameters, found nothing"));
  EXPECT_THAT(refusal("young_modulus: 1\ncurves: {a: [[0, 0]]}\n"),
              HasSubstr("curves.a: must have at least 2 entries"));
}

TEST(Schema, RulesAcrossKeysRunLast) {
  EXPECT_EQ(refusal("young_modulus: 1\nlayers: [bonded, bonded, bonded, bonded]\n"),
            "beam.yaml:1:1: at most three layers");
  EXPECT_THAT(refusal("young_modulus: x\nlayers: [bonded, bonded, bonded, bonded]\n"),
              Not(HasSubstr("three layers")));
}

TEST(Schema, OptionalMayBeSetToNothing) {
  EXPECT_FALSE(read("young_modulus: 1\ndensity: null\n").density.has_value());
}

TEST(Schema, PositionOfWhatWasSetIsTheCommandLine) {
  Node root = parse_yaml("young_modulus: 1\n", "beam.yaml");
  set_value(root, "record.every=none");
  EXPECT_EQ(messages([&] { deck_schema().read(root); }),
            "--set record.every: every: expected an integer, found 'none'");
}

TEST(Schema, DeclaringTwiceIsAMistakeOfTheProgrammer) {
  EXPECT_THROW(record_schema().integer("every", &Record::every, {.text = "Again."}), std::logic_error);
}

TEST(Schema, EchoHoldsEveryDefault) {
  const Node echo = deck_schema().echo(read("young_modulus: 1\n"));
  EXPECT_EQ(echo.find("poisson_ratio")->text, "0.2");
  EXPECT_EQ(echo.find("record")->find("every")->text, "10");
  EXPECT_EQ(echo.find("density"), nullptr);
}

TEST(Schema, EchoReadsBackToItself) {
  for (const char* text : {full_deck, "young_modulus: 1\n"}) {
    const std::string echo = to_yaml(deck_schema().echo(read(text)));
    EXPECT_EQ(to_yaml(deck_schema().echo(read(echo))), echo);
    EXPECT_EQ(read(echo).title, read(text).title);
    EXPECT_EQ(read(echo).mesh, read(text).mesh);
  }
}

RC_GTEST_PROP(Schema, EchoKeepsEveryValue,
              (double modulus, double x, double y, std::string title, bool fields)) {
  RC_PRE(modulus > 0);
  Deck deck = read("young_modulus: 1\n");
  deck.young_modulus = modulus;
  deck.origin = Vec2(x, y);
  deck.record.fields = fields;
  for (char c : title)
    if (static_cast<unsigned char>(c) < 0x80) deck.title += c;
  const Deck back = read(to_yaml(deck_schema().echo(deck)));
  RC_ASSERT(back.young_modulus == deck.young_modulus);
  RC_ASSERT(back.origin == deck.origin);
  RC_ASSERT(back.title == deck.title);
  RC_ASSERT(back.record.fields == deck.record.fields);
}

}  // namespace
}  // namespace dda
