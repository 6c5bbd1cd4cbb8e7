#include <gmock/gmock.h>

#include "framework/deck/writing/keys.hpp"
#include "unit/framework/deck/deck_example.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using example::deck_schema;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

std::vector<std::string> texts(const std::vector<Proposal>& list) {
  std::vector<std::string> out;
  for (const Proposal& one : list) out.push_back(one.text);
  return out;
}

std::vector<std::string> settings(const std::string& begun) {
  return texts(proposed_settings(deck_schema(), parse_yaml(example::full_deck, "deck.yaml"), begun));
}

TEST(Keys, OfSectionsMapsAndLists) {
  std::vector<std::string> paths;
  for (const DeckKey& key : keys_of(deck_schema(), "deck.")) paths.push_back(key.path);
  EXPECT_THAT(paths, Contains("deck.title"));
  EXPECT_THAT(paths, Contains("deck.record.every"));
  EXPECT_THAT(paths, Contains("deck.interfaces.NAME.thickness"));
}

TEST(Keys, AreFoundByWordsOfNameAndText) {
  const std::string found = find_in_manual(deck_schema(), "STIFF");
  EXPECT_THAT(found, HasSubstr("  young_modulus: number [F/L²], above 0, required\n      Stiffness.\n"));
  EXPECT_THAT(found, Not(HasSubstr("poisson_ratio")));
  EXPECT_THAT(find_in_manual(deck_schema(), "thick"), HasSubstr("  interfaces.NAME.thickness: "));
  EXPECT_THAT(find_in_manual(deck_schema(), "first crack"), HasSubstr("  test_law/softening.strength: "));
  EXPECT_THAT(find_in_manual(deck_schema(), "two sides"), HasSubstr("  test_law/bonded\n"));
}

TEST(Keys, OfUnknownWordsAreSuggested) {
  const auto refusal = [](const std::string& word) {
    return messages([&] { find_in_manual(deck_schema(), word); });
  };
  EXPECT_THAT(refusal("densty"),
              HasSubstr("no key of decks has 'densty' in its name or text; did you mean 'density'?"));
  EXPECT_THAT(refusal(""), HasSubstr("no key of decks has ''"));
  EXPECT_THAT(refusal("quaternion"), EndsWith("in its name or text; `dda explain` lists all"));
}

TEST(Settings, BeginWithKeys) {
  EXPECT_THAT(settings("re"), ElementsAre("record."));
  EXPECT_THAT(settings("record."), ElementsAre("record.every=", "record.fields=", "record.stops."));
  EXPECT_THAT(settings("record.f"), ElementsAre("record.fields="));
  EXPECT_THAT(settings("p"), ElementsAre("poisson_ratio="));
}

TEST(Settings, HaveTheNamesOfTheDeck) {
  EXPECT_THAT(settings("interfaces."), ElementsAre("interfaces.joint.", "interfaces.bed."));
  EXPECT_THAT(settings("interfaces.joint."),
              ElementsAre("interfaces.joint.law.", "interfaces.joint.law=", "interfaces.joint.thickness="));
  EXPECT_THAT(settings("layers."), UnorderedElementsAre("layers.0.", "layers.0=", "layers.1.", "layers.1="));
}

TEST(Settings, OfAChoiceAreThoseOfItsMember) {
  EXPECT_THAT(settings("interfaces.joint.law.s"), ElementsAre("interfaces.joint.law.strength="));
  EXPECT_THAT(settings("interfaces.bed.law."), ElementsAre("interfaces.bed.law.type="));
  EXPECT_THAT(texts(proposed_settings(deck_schema(), Node::map(), "interfaces.other.law.")),
              Contains("interfaces.other.law.strength="));
}

TEST(Settings, HaveValues) {
  EXPECT_THAT(settings("state="), ElementsAre("state=plane_stress", "state=plane_strain"));
  EXPECT_THAT(settings("record.fields=t"), ElementsAre("record.fields=true"));
  EXPECT_THAT(settings("interfaces.joint.law=b"), ElementsAre("interfaces.joint.law=bonded"));
  EXPECT_THAT(settings("interfaces.joint.law.type=s"), ElementsAre("interfaces.joint.law.type=softening"));
  EXPECT_THAT(settings("young_modulus="), IsEmpty());
}

TEST(Settings, OfWhatIsNotThereAreNone) {
  for (const char* begun : {"nothing", "nothing.at.all", "title.more", "layers.99.", "layers.x.y.z",
                            "record.every.more=", "..", "="})
    EXPECT_THAT(settings(begun), IsEmpty()) << begun;
}

TEST(Topics, AreSectionsFamiliesAndMembers) {
  EXPECT_THAT(texts(proposed_topics(deck_schema(), "rec")), ElementsAre("record"));
  EXPECT_THAT(texts(proposed_topics(deck_schema(), "test_l")), ElementsAre("test_law"));
  EXPECT_THAT(texts(proposed_topics(deck_schema(), "test_law/")),
              ElementsAre("test_law/bonded", "test_law/softening"));
  EXPECT_THAT(texts(proposed_topics(deck_schema(), "record.e")), ElementsAre("record.every"));
}

}  // namespace
}  // namespace dda
