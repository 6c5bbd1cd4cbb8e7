#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "framework/figure/axis.hpp"

namespace dda::svg {
namespace {

Range between(double low, double high) {
  Range range;
  range.include(low);
  range.include(high);
  return range;
}

TEST(Range, GrowsOverFiniteNumbersOnly) {
  Range range;
  range.include(std::nan(""));
  EXPECT_TRUE(range.empty);
  range.include(3);
  range.include(-1);
  range.include(INFINITY);
  EXPECT_EQ(range.low, -1);
  EXPECT_EQ(range.high, 3);
}

TEST(Range, NeverHasLengthZeroOnceWidened) {
  for (const double value : {0.0, 5.0, -1e-300, 1e300, 1e6 * (1 + 1e-15)}) {
    const Range range = between(value, value).widened(0);
    EXPECT_LT(range.low, range.high);
    EXPECT_LE(range.low, value);
    EXPECT_GE(range.high, value);
  }
  EXPECT_LT(Range().widened(0).low, Range().widened(0).high);
}

TEST(Axis, TicksAreRoundFewAndInside) {
  for (const auto& [low, high] : {std::pair{0.0, 1.0},
                                  {-3400.0, 12.0},
                                  {1e-9, 5e-9},
                                  {0.0, 9.99e12},
                                  {-0.07, 0.0003},
                                  {1e6, 1e6 + 1e-3},
                                  {-1e6 - 1e-3, -1e6}}) {
    const Axis axis = make_axis(between(low, high), 6);
    EXPECT_GE(axis.ticks.size(), 3u) << low << " " << high;
    EXPECT_LE(axis.ticks.size(), 8u) << low << " " << high;
    std::set<std::string> labels;
    for (const Tick& tick : axis.ticks) {
      EXPECT_GE(tick.value, low - 1e-6 * (high - low));
      EXPECT_LE(tick.value, high + 1e-6 * (high - low));
      EXPECT_LE(tick.label.size(), 12u) << tick.label;
      labels.insert(tick.label);
    }
    EXPECT_EQ(labels.size(), axis.ticks.size()) << "labels tell ticks apart";
  }
}

TEST(Axis, PlainNumbersNeedNoScale) {
  const Axis axis = make_axis(between(-1, 1), 4);
  EXPECT_EQ(axis.scale, "");
  ASSERT_EQ(axis.ticks.size(), 5u);
  EXPECT_EQ(axis.ticks[0].label, "−1.0");
  EXPECT_EQ(axis.ticks[2].label, "0.0");
}

TEST(Axis, TinyHugeAndShiftedNumbersAreScaled) {
  EXPECT_EQ(make_axis(between(0, 5e-9), 5).scale, "×10⁻⁹");
  EXPECT_EQ(make_axis(between(0, 5e12), 5).scale, "×10¹²");
  EXPECT_EQ(make_axis(between(1e6, 1e6 + 5e-6), 5).scale, "×10⁻⁶ + 1000000");
}

std::vector<std::string> labels_of(const Axis& axis) {
  std::vector<std::string> out;
  for (const Tick& tick : axis.ticks)
    if (!tick.is_minor) out.push_back(tick.label);
  return out;
}

using Labels = std::vector<std::string>;

TEST(LogarithmicAxis, DecadesHaveLabelsAndTheDigitsBetweenThemTicks) {
  const Axis axis = make_logarithmic_axis(between(-2, 1), 6);
  EXPECT_EQ(labels_of(axis), (Labels{"0.01", "0.1", "1", "10"}));
  EXPECT_EQ(axis.ticks.size(), 4u + 3 * 8);
  EXPECT_NEAR(axis.ticks[1].value, std::log10(0.02), 1e-12);
  EXPECT_TRUE(axis.ticks[1].is_minor);
  EXPECT_EQ(labels_of(make_logarithmic_axis(between(-7.5, -5.2), 6)), (Labels{"10⁻⁷", "10⁻⁶"}));
}

TEST(LogarithmicAxis, OfManyDecadesFewHaveLabels) {
  const Axis axis = make_logarithmic_axis(between(-9, 9), 6);
  EXPECT_EQ(labels_of(axis), (Labels{"10⁻⁸", "10⁻⁴", "1", "10000", "10⁸"}));
  EXPECT_EQ(axis.ticks.size(), 19u);
}

TEST(LogarithmicAxis, ShortRangesHaveRoundNumbers) {
  EXPECT_EQ(labels_of(make_logarithmic_axis(between(std::log10(0.8), std::log10(7)), 6)),
            (Labels{"1", "2", "5"}));
  const Axis shortest = make_logarithmic_axis(between(std::log10(31), std::log10(38)), 4);
  EXPECT_EQ(labels_of(shortest), (Labels{"32", "34", "36", "38"}));
  EXPECT_NEAR(shortest.ticks[0].value, std::log10(32), 1e-12);
}

}  // namespace
}  // namespace dda::svg
