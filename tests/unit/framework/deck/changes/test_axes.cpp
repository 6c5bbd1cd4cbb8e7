#include <gmock/gmock.h>

#include "framework/deck/changes/axes.hpp"
#include "framework/deck/changes/settings.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Axis> axes(const std::string& text) { return read_axes(parse_yaml(text, "s.yaml")); }

std::string refusal(const std::string& text) {
  return messages([&] { axes(text); });
}

std::vector<std::string> texts(const SweptKey& key) {
  std::vector<std::string> out;
  for (const Node& value : key.values) out.push_back(to_flow_yaml(value));
  return out;
}

std::vector<std::string> values(const std::string& range) { return texts(axes("a: " + range)[0].keys[0]); }

TEST(Range, OfIntegers) {
  EXPECT_THAT(values("1..4"), ElementsAre("1", "2", "3", "4"));
  EXPECT_THAT(values("-1..1"), ElementsAre("-1", "0", "1"));
  EXPECT_THAT(values("7..7"), ElementsAre("7"));
  EXPECT_THAT(values("'1..2'"), ElementsAre("1", "2"));
  EXPECT_THAT(values("10..35 step 10"), ElementsAre("10", "20", "30"));
}

TEST(Range, OfNumbersIsWhatOneWouldWrite) {
  EXPECT_THAT(values("0.1..0.5 step 0.1"), ElementsAre("0.1", "0.2", "0.3", "0.4", "0.5"));
  EXPECT_THAT(values("1..2 step 0.5"), ElementsAre("1", "1.5", "2"));
  EXPECT_EQ(values("0.1..1 step 0.1").size(), 10u);
  EXPECT_EQ(values("0..1 step 0.001").size(), 1001u);
}

TEST(Range, Logarithmic) {
  EXPECT_THAT(values("0.01..100 log 5"), ElementsAre("0.01", "0.1", "1", "10", "100"));
  EXPECT_THAT(values("1..4 log 3"), ElementsAre("1", "2", "4"));
}

TEST(Range, StandsWhereItIsWritten) {
  EXPECT_EQ(to_string(axes("a:\n  1..3")[0].keys[0].values[2].where), "s.yaml:2:3");
}

TEST(Range, RefusesWhatIsNone) {
  EXPECT_THAT(refusal("a: 0.1..1"),
              HasSubstr("s.yaml:1:4: range '0.1..1': a range of numbers that are no integers needs a step"));
  EXPECT_THAT(refusal("a: 5..1"), HasSubstr("ends before it begins"));
  EXPECT_THAT(refusal("a: 1..x"), HasSubstr("'x' is not a number"));
  EXPECT_THAT(refusal("a: 1..5 by 2"), HasSubstr("a range is 1..20"));
  EXPECT_THAT(refusal("a: 1..5 step 2 3"), HasSubstr("a range is 1..20"));
  EXPECT_THAT(refusal("a: 1..5 step"), HasSubstr("a range is 1..20"));
  EXPECT_THAT(refusal("a: 1..5 step 0"), HasSubstr("the step must be above 0"));
  EXPECT_THAT(refusal("a: 0..5 log 3"), HasSubstr("begins above 0"));
  EXPECT_THAT(refusal("a: 1..5 log 1"), HasSubstr("2 or more"));
  EXPECT_THAT(refusal("a: 1..5 log 2.5"), HasSubstr("2 or more"));
  EXPECT_THAT(refusal("a: 1..1000000000000"), HasSubstr("more than 100000 values"));
}

TEST(Axes, AreEntriesInOrder) {
  const auto all = axes("path.stop.steps: [3, 5]\nlaw: [{type: bonded}, null, text]");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].keys[0].name, "path.stop.steps");
  EXPECT_EQ(to_string(all[1].keys[0].where), "s.yaml:2:1");
  EXPECT_THAT(texts(all[1].keys[0]), ElementsAre("{type: bonded}", "", "text"));
}

TEST(Axes, ZipVariesKeysTogether) {
  const auto one = axes("zip: {a: [1, 2], b: 5..6}");
  ASSERT_EQ(one.size(), 1u);
  EXPECT_THAT(texts(one[0].keys[1]), ElementsAre("5", "6"));
  const auto two = axes("zip:\n  - {a: [1, 2], b: [3, 4]}\n  - {c: 1..3, d: 4..6}\ne: [7]");
  ASSERT_EQ(two.size(), 3u);
  EXPECT_EQ(two[1].size(), 3u);
  EXPECT_EQ(two[1].keys[1].name, "d");
}

TEST(Axes, RefusesWithPosition) {
  EXPECT_THAT(refusal("zip:\n  a: [1, 2]\n  b: [3]"),
              HasSubstr("s.yaml:3:3: zip: 'b' has 1 values, 'a' has 2"));
  EXPECT_THAT(refusal("zip: [3]"), HasSubstr("s.yaml:1:7: zip: expected a map"));
  EXPECT_THAT(refusal("a: [1]\nzip: {a: [2]}"),
              HasSubstr("s.yaml:2:7: 'a' is varied twice, first at s.yaml:1:1"));
  EXPECT_THAT(refusal("a: 3"), HasSubstr("s.yaml:1:4: a: expected a list of values"));
  EXPECT_THAT(refusal("a: {b: [1]}"), HasSubstr("expected a list of values"));
  EXPECT_THAT(refusal("a: []"), HasSubstr("the list is empty"));
  EXPECT_THAT(refusal("{}"), HasSubstr("nothing is varied"));
  EXPECT_THAT(refusal("[1]"), HasSubstr("expected a map"));
  EXPECT_THAT(refusal("a: 1..1000\nb: 1..1000"), HasSubstr("1e+06 cases"));
}

TEST(Axes, EveryMistakeIsSaidAtOnce) {
  const std::string said = refusal("a: 3\nb: 2..1");
  EXPECT_THAT(said, HasSubstr("s.yaml:1:4"));
  EXPECT_THAT(said, HasSubstr("s.yaml:2:4"));
}

TEST(Axes, LastOneRunsFastest) {
  EXPECT_THAT(cases_of(axes("a: [1, 2]\nb: 1..3")),
              ElementsAre(ElementsAre(0, 0), ElementsAre(0, 1), ElementsAre(0, 2), ElementsAre(1, 0),
                          ElementsAre(1, 1), ElementsAre(1, 2)));
}

}  // namespace
}  // namespace dda
