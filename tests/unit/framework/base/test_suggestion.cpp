#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

/// Few letters, so that random words come near each other.
rc::Gen<std::string> words() {
  return rc::gen::container<std::string>(rc::gen::elementOf(std::string("abc")));
}

TEST(Suggestion, DistanceCountsEdits) {
  EXPECT_EQ(edit_distance("strenght", "strength"), 2u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
}

RC_GTEST_PROP(Suggestion, DistanceIsAMetric, ()) {
  const auto a = *words(), b = *words(), c = *words();
  RC_ASSERT((edit_distance(a, b) == 0) == (a == b));
  RC_ASSERT(edit_distance(a, b) == edit_distance(b, a));
  RC_ASSERT(edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c));
}

TEST(Suggestion, NearNameIsSuggested) {
  EXPECT_EQ(suggest("strenght", {"energy", "strength"}), "; did you mean 'strength'?");
  EXPECT_EQ(suggest("Young_modulus", {"young_modulus"}), "; did you mean 'young_modulus'?");
}

TEST(Suggestion, FarNameListsAll) {
  EXPECT_EQ(suggest("colour", {"a", "bb", "energy"}), "; known are a, bb and energy");
  EXPECT_EQ(suggest("colour", {"energy"}), "; known is energy");
  EXPECT_EQ(suggest("xy", {"ab"}), "; known is ab") << "no letter survives";
  EXPECT_EQ(suggest("xy", {}), "; there are none to choose from");
}

TEST(Suggestion, LongNamesMayDifferInAThird) {
  EXPECT_EQ(suggest("fracturenergie", {"fracture_energy"}), "; did you mean 'fracture_energy'?");
}

}  // namespace
}  // namespace dda
