#include <gmock/gmock.h>

#include "framework/deck/family.hpp"
#include "framework/deck/writing/explain.hpp"
#include "unit/framework/deck/deck_example.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using example::deck_schema;
using testing::HasSubstr;

TEST(Explain, OverviewListsSectionsAndFamilies) {
  const std::string text = explain(deck_schema(), "");
  EXPECT_THAT(text, HasSubstr("  record         What is stored."));
  EXPECT_THAT(text, HasSubstr("test_law"));
  EXPECT_THAT(text, HasSubstr("What the interface of a test does."));
}

TEST(Explain, FamilyListsItsMembers) {
  const std::string text = explain(deck_schema(), "test_law");
  EXPECT_THAT(text, HasSubstr("  bonded     Two sides that stay together."));
  EXPECT_THAT(text, HasSubstr("  softening  Softening to a stress-free crack."));
}

TEST(Explain, MemberListsItsParameters) {
  const std::string text = explain(deck_schema(), "test_law/softening");
  EXPECT_THAT(text,
              HasSubstr("strength: number [F/L²], above 0, required\n      Traction at the first crack."));
  EXPECT_THAT(text, HasSubstr("exponent: integer, between 1 and 9, default 1\n"));
  EXPECT_THAT(explain(deck_schema(), "test_law/softening", Units{}), HasSubstr("strength: number [MPa]"));
  EXPECT_THAT(explain(deck_schema(), "test_law/bonded"), HasSubstr("It has no parameters."));
}

TEST(Explain, SectionsHoweverDeep) {
  EXPECT_THAT(explain(deck_schema(), "record"), HasSubstr("every: integer, at least 1, default 10"));
  EXPECT_THAT(explain(deck_schema(), "record.stops"),
              HasSubstr("stops: list of: number [L], above 0, default []"));
  EXPECT_THAT(explain(deck_schema(), "interfaces/thickness"), HasSubstr("number [L], above 0, default 1"));
  EXPECT_THAT(explain(deck_schema(), "interfaces/law/softening"), HasSubstr("Work per area of crack."));
  EXPECT_THAT(explain(deck_schema(), "density"), HasSubstr("may be left out"));
}

TEST(Explain, UnknownNamesAreSuggested) {
  const auto refusal = [](const std::string& path) {
    return messages([&] { explain(deck_schema(), path); });
  };
  EXPECT_EQ(refusal("recrod"), "nothing is known of 'recrod'; did you mean 'record'?");
  EXPECT_EQ(refusal("test_lwa"), "nothing is known of 'test_lwa'; did you mean 'test_law'?");
  EXPECT_EQ(refusal("sofetning"), "nothing is known of 'sofetning'; did you mean 'softening'?");
  EXPECT_EQ(messages([] { explain(deck_schema(), "standstil", Units{}, {"standstill"}); }),
            "nothing is known of 'standstil'; did you mean 'standstill'?");
  EXPECT_EQ(refusal("test_law/bnded"), "nothing is known of 'bnded'; did you mean 'bonded'?");
  EXPECT_THAT(refusal("record/every/more"), HasSubstr("nothing is known of 'more'"));
}

TEST(Explain, EveryParameterIsExplained) {
  for (const FamilyBase* family : all_families())
    for (const FamilyMember* member : family->entries())
      for (const Parameter& parameter : member->schema->parameters())
        EXPECT_THAT(explain(deck_schema(), family->name() + "/" + member->name),
                    HasSubstr("  " + parameter.name + ": "));
}

}  // namespace
}  // namespace dda
