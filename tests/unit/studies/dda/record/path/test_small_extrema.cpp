#include <gtest/gtest.h>

#include "studies/dda/record/path/small_extrema.hpp"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

Json extremum(double load, double cmod, bool of_load = true) {
  return {{"kind", of_load ? "limit_point" : "turning_point"},
          {"of", of_load ? "load" : "cmod"},
          {"load", load},
          {"gauges", {{"cmod", cmod}}}};
}

Measurement at(double load, double cmod) { return {.control = "", .load = load, .values = {cmod}}; }

const std::vector<Column> names{{"cmod", "mm"}};

std::vector<double> loads(const Json& events) {
  std::vector<double> out;
  for (const Json& event : events) out.push_back(event["load"]);
  return out;
}

TEST(SmallExtrema, AreCountedNotListed) {
  // A saw of single blocks on the way up, the peak, a drop of 1 % and a rise, a saw on the way down.
  const Json events{extremum(50, 1),   extremum(49.9, 1), extremum(70, 1),   extremum(69.8, 2),
                    extremum(100, 3),  extremum(99, 4),   extremum(99.8, 5), extremum(60, 6),
                    extremum(60.2, 7), extremum(59.9, 8), extremum(60.1, 9)};
  const ListedEvents found = listed_events(events, at(0, 0), at(10, 12), names);
  EXPECT_EQ(loads(found.listed), (std::vector<double>{100, 99, 99.8}));
  EXPECT_EQ(found.small["load"], 8);
  EXPECT_EQ(found.small["depth"], listed_depth);
}

TEST(SmallExtrema, ThePeakStaysHoweverLittleTheLoadFalls) {
  const ListedEvents found = listed_events(Json::array({extremum(100, 1)}), at(0, 0), at(99.9, 1.1), names);
  EXPECT_EQ(loads(found.listed), std::vector<double>{100});
  EXPECT_TRUE(found.small.is_null());
}

TEST(SmallExtrema, GaugesAndOtherEventsHaveTheirOwn) {
  Json bifurcation = extremum(40, 1);
  bifurcation["kind"] = "bifurcation";
  const Json events{bifurcation, extremum(50, 2, false), extremum(45, 1.995, false), extremum(44, 3, false),
                    extremum(30, 1, false)};
  const ListedEvents found = listed_events(events, at(0, 0), at(10, 5), names);
  EXPECT_EQ(loads(found.listed), (std::vector<double>{40, 44, 30}));
  EXPECT_EQ(found.small["cmod"], 2);
  EXPECT_FALSE(found.small.contains("load"));
}

/// The loads of two stages are others, however alike: neither is small beside the other.
TEST(SmallExtrema, StagesHaveTheirOwn) {
  Json events{extremum(100, 1), extremum(50, 2), extremum(49.9, 2), extremum(100, 3)};
  for (std::size_t i = 0; i < events.size(); ++i) events[i]["stage"] = i < 1 ? 1 : 2;
  const ListedEvents found = listed_events(events, at(0, 0), at(10, 4), names);
  EXPECT_EQ(loads(found.listed), (std::vector<double>{100, 100}));
  EXPECT_EQ(found.small["load"], 2);
}

TEST(SmallExtrema, NoEventsNoCounts) {
  const ListedEvents found = listed_events(Json::array(), at(0, 0), at(1, 1), names);
  EXPECT_TRUE(found.listed.empty());
  EXPECT_TRUE(found.small.is_null());
}

}  // namespace
}  // namespace dda
