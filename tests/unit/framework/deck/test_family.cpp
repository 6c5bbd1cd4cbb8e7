#include <gmock/gmock.h>

#include "framework/deck/family.hpp"
#include "unit/framework/deck/deck_example.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using namespace example;
using testing::HasSubstr;

Choice<Law, double> choose(const std::string& text) {
  return laws().choose(*parse_yaml("law: " + text, "a.yaml").find("law"));
}

std::string refusal_of_kind(const std::string& text) {
  return messages([&] { choose(text); });
}

TEST(Family, BothFormsOfTheDeck) {
  EXPECT_EQ(choose("bonded").name(), "bonded");
  EXPECT_EQ(choose("{type: bonded}").name(), "bonded");
  EXPECT_EQ(choose("{type: softening, strength: 3, energy: 1}").make(2.0)->strength, 6.0);
}

TEST(Family, RefusalsNameTheMember) {
  EXPECT_EQ(refusal_of_kind("softning"),
            "a.yaml:1:6: unknown test_law 'softning'; did you mean 'softening'?");
  EXPECT_EQ(refusal_of_kind("{type: elastic}"),
            "a.yaml:1:13: unknown test_law 'elastic'; known are bonded and softening");
  EXPECT_EQ(refusal_of_kind("{type: softening, strength: 3, energi: 1}"),
            "a.yaml:1:6: missing parameter 'energy' in test_law 'softening' (number in F/L, above 0)\n"
            "a.yaml:1:37: unknown parameter 'energi' in test_law 'softening'; did you mean 'energy'?");
  EXPECT_THAT(refusal_of_kind("{strength: 3}"), HasSubstr("missing 'type' of the test_law"));
  EXPECT_THAT(refusal_of_kind("[1]"), HasSubstr("found a list"));
  EXPECT_THAT(refusal_of_kind("{type: [1]}"), HasSubstr("expected the name of a test_law"));
  EXPECT_THAT(refusal_of_kind("{type: softening, strength: 1, energy: 200}"),
              HasSubstr("too large for the strength"));
}

TEST(Family, MakersKnowThePlaceOfTheirParameters) {
  const auto choice = choose("{type: softening, strength: 3, energy: 1}");
  EXPECT_EQ(to_string(choice.where()), "a.yaml:1:6");
  EXPECT_EQ(messages([&] { choice.make(-1.0); }), "a.yaml:1:6: no room for the law");
}

TEST(Family, ChoiceByNameAndParameters) {
  const auto choice = laws().choose("softening", parse_yaml("{strength: 2, energy: 1}", "x"));
  EXPECT_EQ(choice.make(1.0)->strength, 2.0);
  EXPECT_EQ(laws().choose("bonded").make(1.0)->made, "bonded");
}

TEST(Family, EchoReadsBack) {
  EXPECT_EQ(to_yaml(choose("{type: bonded}").echo()), "bonded\n");
  const Node echo = choose("{type: softening, strength: 0.1, energy: 1e-3}").echo();
  EXPECT_EQ(to_yaml(echo), "type: softening\nstrength: 0.1\nenergy: 0.001\nexponent: 1\n");
  EXPECT_TRUE(laws().choose(echo).echo() == echo);
}

TEST(Family, EmptyChoice) {
  const Choice<Law, double> empty;
  EXPECT_TRUE(empty.is_empty());
  EXPECT_TRUE(empty.echo().is_null());
  EXPECT_THROW(empty.make(1.0), std::logic_error);
}

TEST(Family, EntriesAreInAlphabeticalOrder) {
  std::vector<std::string> names;
  for (const FamilyMember* member : laws().entries()) names.push_back(member->name);
  EXPECT_THAT(names, testing::ElementsAre("bonded", "softening"));
}

TEST(Family, AllFamiliesKnowsThisOne) { EXPECT_THAT(all_families(), testing::Contains(&laws())); }

TEST(Family, ForgottenWhenItEnds) {
  const auto before = all_families();
  {
    Family<Law> local("local", "For a moment.");
    EXPECT_EQ(all_families().size(), before.size() + 1);
  }
  EXPECT_EQ(all_families(), before);
}

struct Nothing {};
struct Typed {
  int type = 0;
};

TEST(Family, MistakesOfTheProgrammer) {
  Family<Law> local("local", "For a moment.");
  const auto make = [](const auto&) { return std::make_unique<Law>(); };
  local.add("one", Schema<Nothing>("Nothing."), make);
  EXPECT_THROW(local.add("one", Schema<Nothing>("Nothing."), make), std::logic_error);
  EXPECT_THROW(local.add("two", Schema<Typed>("T.").integer("type", &Typed::type, {.text = "."}), make),
               std::logic_error);
}

}  // namespace
}  // namespace dda
