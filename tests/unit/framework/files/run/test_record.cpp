#include <gtest/gtest.h>

#include "framework/files/run/record.hpp"

namespace dda {
namespace {

struct Everything {
  double load = 0;
  int step = 0;
  long long count = 0;
  bool is_open = false;
  std::optional<int> some, none = 7;
  Vec2 place{0, 0};
  std::string text;
  std::vector<double> values;
  std::vector<Vec2> places;
  std::array<double, 2> numbers{};
  std::vector<std::vector<double>> shapes, no_shapes = {{1}};

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("load", self.load);
    visit("step", self.step);
    visit("count", self.count);
    visit("is_open", self.is_open);
    visit("some", self.some);
    visit("none", self.none);
    visit("place", self.place);
    visit("text", self.text);
    visit("values", self.values);
    visit("places", self.places);
    visit("numbers", self.numbers);
    visit("shapes", self.shapes);
    visit("no_shapes", self.no_shapes);
  }
};

TEST(Record, IsReadBackAsItWasWritten) {
  const Everything written{.load = 0.1,
                           .step = -3,
                           .count = 1LL << 40,
                           .is_open = true,
                           .some = 5,
                           .none = std::nullopt,
                           .place = {1.5, -2},
                           .text = "corner",
                           .values = {1e-300, 2},
                           .places = {{1, 2}, {3, 4}},
                           .numbers = {-1, 1e300},
                           .shapes = {{1, 2}, {3, 4}, {5, 6}},
                           .no_shapes = {}};
  RestartData data;
  put(data, "all", written);
  const auto read = take<Everything>(data, "all");
  EXPECT_EQ(read.load, written.load);
  EXPECT_EQ(read.step, written.step);
  EXPECT_EQ(read.count, written.count);
  EXPECT_EQ(read.is_open, written.is_open);
  EXPECT_EQ(read.some, written.some);
  EXPECT_EQ(read.none, written.none);
  EXPECT_EQ(read.place, written.place);
  EXPECT_EQ(read.text, written.text);
  EXPECT_EQ(read.values, written.values);
  EXPECT_EQ(read.places, written.places);
  EXPECT_EQ(read.numbers, written.numbers);
  EXPECT_EQ(read.shapes, written.shapes);
  EXPECT_EQ(read.no_shapes, written.no_shapes);
}

struct Crack {
  int step = 0;
  Vec2 at{0, 0};

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("step", self.step);
    visit("at", self.at);
  }
};

TEST(Record, ManyAreOneArray) {
  RestartData data;
  put_all<Crack>(data, "cracks", {{1, {2, 3}}, {4, {5, 6}}});
  EXPECT_EQ(data.numbers.at("cracks"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(data.texts.at("cracks.members"), (std::vector<std::string>{"step", "at", "at"}));
  const auto read = take_all<Crack>(data, "cracks");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].step, 4);
  EXPECT_EQ(read[1].at, Vec2(5, 6));
  put_all<Crack>(data, "none", {});
  EXPECT_TRUE(take_all<Crack>(data, "none").empty());
}

TEST(Record, OtherMembersAreRefused) {
  RestartData data;
  put(data, "crack", Crack{1, {2, 3}});
  data.texts["crack.members"][0] = "stage";
  EXPECT_THROW(take<Crack>(data, "crack"), std::runtime_error);
  EXPECT_THROW(take<Everything>(data, "crack"), std::runtime_error);
  EXPECT_THROW(take<Crack>(data, "nothing"), std::runtime_error);
  data.numbers["crack"].pop_back();
  data.texts["crack.members"][0] = "step";
  EXPECT_THROW(take<Crack>(data, "crack"), std::runtime_error);
}

}  // namespace
}  // namespace dda
