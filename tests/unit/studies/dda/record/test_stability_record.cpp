#include <gtest/gtest.h>

#include <cmath>

#include "framework/files/whole_file.hpp"
#include "studies/dda/figures/stability_pictures.hpp"
#include "studies/dda/record/stability_record.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

/// Rows of load 1, 2, … with these two counts.
CsvTable curve_of(const std::vector<std::pair<const char*, const char*>>& counts) {
  const test::Scratch scratch;
  std::string text =
      "step,load,cmod,negative_eigenvalues,negative_under_control,negative_second_order_work\n";
  for (std::size_t i = 0; i < counts.size(); ++i)
    text += std::to_string(i) + "," + std::to_string(i + 1) + "," + std::to_string(i) + "," +
            counts[i].first + "," + counts[i].second + "," + counts[i].first + "\n";
  write_whole(scratch / "curve.csv", text, Flush::to_system);
  return read_csv(scratch / "curve.csv");
}

TEST(StabilityRecord, UnknownIsNeverStable) {
  const CsvTable curve =
      curve_of({{"0", "0"}, {"nan", "nan"}, {"0", "0"}, {"0", "0"}, {"1", "0"}, {"2", "1"}});
  using enum Stability;
  EXPECT_EQ(stability_of(curve), (std::vector{stable, unknown, stable, stable, under_control, unstable}));
  EXPECT_EQ(between(stability_of(curve)), (std::vector{unknown, unknown, stable, stable, under_control}));
  const auto counts = stability_counts(curve);
  EXPECT_EQ(counts["unknown"], 1);
  EXPECT_EQ(counts["stable"], 3);
  EXPECT_EQ(counts["positive_second_order_work"], 3);
}

TEST(StabilityRecord, UnknownIsDotted) {
  const auto series = by_stability({curve_of({{"nan", "nan"}, {"nan", "nan"}})}, "cmod", "load");
  ASSERT_EQ(series.size(), 1u);
  EXPECT_TRUE(series[0].dotted);
  EXPECT_EQ(series[0].name, "stability not known");
}

TEST(StabilityRecord, StableAloneNeedsNoLegend) {
  const auto series = by_stability({curve_of({{"0", "0"}, {"0", "0"}})}, "cmod", "load");
  ASSERT_EQ(series.size(), 1u);
  EXPECT_TRUE(series[0].name.empty() && !series[0].dotted && !series[0].dashed);
}

TEST(StabilityRecord, PiecesMeet) {
  const auto series =
      by_stability({curve_of({{"0", "0"}, {"0", "0"}, {"1", "0"}, {"1", "0"}})}, "cmod", "load");
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].x, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(series[1].x, (std::vector<double>{2, 3}));
  EXPECT_TRUE(series[1].dashed && !series[1].dotted);
}

TEST(StabilityRecord, AStageBeginsWhereTheOneBeforeIsHeld) {
  const test::Scratch scratch;
  write_whole(scratch / "curve.csv",
              "step,load,u,negative_eigenvalues,negative_under_control,stage\n"
              "0,0,0,0,0,1\n1,5,1,0,0,1\n2,7,3,0,0,2\n3,9,4,0,0,2\n4,1,6,0,0,4\n",
              Flush::to_system);
  const CsvTable curve = read_csv(scratch / "curve.csv");
  const auto series = by_stability({curve, {{4, -2}}}, "u", "load");
  ASSERT_EQ(series.size(), 1u);
  const auto parts_of = [](std::vector<double> values) {
    for (double& value : values)
      if (std::isnan(value)) value = 99;
    return values;
  };
  EXPECT_EQ(parts_of(series[0].x), (std::vector<double>{0, 1, 99, 1, 3, 4, 99, 4, 6}));
  EXPECT_EQ(parts_of(series[0].y), (std::vector<double>{0, 5, 99, 0, 7, 9, 99, -2, 1}));
  EXPECT_EQ(parts_of(whole({curve, {{4, -2}}}, "u", "load").y), parts_of(series[0].y));
}

}  // namespace
}  // namespace dda
