#include <fmt/format.h>
#include <gtest/gtest.h>

#include "framework/files/whole_file.hpp"
#include "studies/dda/record/path/peak.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

struct Row {
  double load, work;
};

CsvTable curve_of(const std::vector<Row>& rows) {
  const test::Scratch scratch;
  std::string text = "step,load,external_work,dissipated_energy\n";
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += fmt::format("{},{},{},{}\n", i, rows[i].load, rows[i].work, 10 * i);
  write_whole(scratch / "curve.csv", text, Flush::to_system);
  return read_csv(scratch / "curve.csv");
}

Json peak_at(int step, double load) {
  return {{"step", step}, {"load_factor", load}, {"load", load}, {"gauges", {{"cmod", 0.1}}}};
}

Json event(const std::string& kind, int step, double load, double dissipated) {
  return {{"kind", kind}, {"step", step}, {"load", load}, {"dissipated_energy", dissipated}};
}

TEST(PathPeak, IsListedInItsPlaceWhereAReleaseFollows) {
  const CsvTable curve = curve_of({{0, 0}, {5, 1}, {4, 1}, {8, 3}, {3, 3}, {6, 5}});
  const Json events{event("limit_point", 2, 4.5, 25), event("bifurcation", 3, 8, 30),
                    event("limit_point", 4, 3.5, 45)};
  const Json found = with_peak(events, peak_at(3, 8), curve);
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[1], events[1]);
  EXPECT_EQ(found[2]["kind"], "limit_point");
  EXPECT_EQ(found[2]["extremum"], "maximum");
  EXPECT_EQ(found[2]["load"], 8);
  EXPECT_EQ(found[2]["dissipated_energy"], 30);
  EXPECT_EQ(found[2]["gauges"]["cmod"], 0.1);
  EXPECT_EQ(found[3], events[2]);
}

TEST(PathPeak, IsListedOnce) {
  const CsvTable curve = curve_of({{0, 0}, {-8, 3}, {-3, 3}});
  for (const double load : {-8.0, -8.1, -8 * (1 - 1e-12)}) {
    const Json events = Json::array({event("limit_point", 1, load, 10)});
    EXPECT_EQ(with_peak(events, peak_at(1, -8), curve), events);
  }
  const Json lower = Json::array({event("limit_point", 1, 8, 10), event("bifurcation", 1, -8, 10)});
  const Json found = with_peak(lower, peak_at(1, -8), curve);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[2]["extremum"], "minimum");
}

TEST(PathPeak, IsNotListedWhileTheLoadRises) {
  EXPECT_TRUE(with_peak(Json::array(), peak_at(2, 8), curve_of({{0, 0}, {5, 1}, {8, 3}})).empty());
  // A last step that is tiny is no plateau; neither is the fall of a load that is largest at the start.
  EXPECT_FALSE(is_passed(curve_of({{0, 0}, {8, 3}, {8 * (1 - 1e-12), 3 + 1e-9}}), 1));
  EXPECT_TRUE(with_peak(Json::array(), peak_at(0, 8), curve_of({{8, 0}, {5, -1}})).empty());
}

TEST(PathPeak, IsPassedByAMechanismUnderTheSameLoad) {
  EXPECT_TRUE(is_passed(curve_of({{0, 0}, {8 * (1 - 1e-11), 3}, {8, 4}, {8 * (1 - 1e-12), 5}}), 2));
  EXPECT_TRUE(is_passed(curve_of({{0, 0}, {8 * (1 - 1e-11), 3}, {8 * (1 - 1e-12), 4}, {8, 5}}), 3));
}

TEST(PathPeak, StaysPassedWhenTheLoadComesBackToIt) {
  EXPECT_TRUE(is_passed(curve_of({{0, 0}, {8, 3}, {2, 3}, {8 * (1 - 1e-12), 3}}), 1));
}

/// Step 2 is the highest load of a second stage, whose loads are others than those of the first.
TEST(PathPeak, IsThatOfItsStage) {
  const test::Scratch scratch;
  write_whole(scratch / "curve.csv",
              "step,load,external_work,dissipated_energy,stage\n0,0,0,0,1\n1,9,1,0,1\n2,8,3,5,2\n3,4,4,9,2\n",
              Flush::to_system);
  const CsvTable curve = read_csv(scratch / "curve.csv");
  EXPECT_TRUE(is_passed(curve, 2));
  EXPECT_FALSE(is_passed(curve, 1)) << "what comes after belongs to the next";
  const Json found = with_peak(Json::array({event("limit_point", 1, 9, 0)}), peak_at(2, 8), curve);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[1]["step"], 2);
  EXPECT_EQ(found[1]["stage"], 2);
}

}  // namespace
}  // namespace dda
