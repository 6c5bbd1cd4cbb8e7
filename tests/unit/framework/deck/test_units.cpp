#include <gtest/gtest.h>

#include "framework/deck/units.hpp"

namespace dda {
namespace {

TEST(Units, LabelsOfMillimetresAndNewtons) {
  const Units units;
  EXPECT_EQ(label(dimension::none, units), "-");
  EXPECT_EQ(label(dimension::length, units), "mm");
  EXPECT_EQ(label(dimension::area, units), "mm²");
  EXPECT_EQ(label(dimension::second_moment, units), "mm⁴");
  EXPECT_EQ(label(dimension::curvature, units), "1/mm");
  EXPECT_EQ(label(dimension::stress, units), "MPa");
  EXPECT_EQ(label(dimension::energy_per_area, units), "N/mm");
  EXPECT_EQ(label(dimension::body_force, units), "N/mm³");
  EXPECT_EQ(label(dimension::moment, units), "N·mm");
  EXPECT_EQ(label(Dimension{-1, 2}, units), "mm²/N");
}

TEST(Units, StressHasItsOwnNameWhereItHasOne) {
  EXPECT_EQ(label(dimension::stress, {"m", "N"}), "Pa");
  EXPECT_EQ(label(dimension::stress, {"m", "kN"}), "kPa");
  EXPECT_EQ(label(dimension::stress, {"m", "MN"}), "MPa");
  EXPECT_EQ(label(dimension::stress, {"mm", "kN"}), "GPa");
  EXPECT_EQ(label(dimension::stress, {"in", "lbf"}), "lbf/in²");
}

TEST(Units, ManualSpeaksOfForceAndLength) { EXPECT_EQ(label(dimension::stress), "F/L²"); }

}  // namespace
}  // namespace dda
