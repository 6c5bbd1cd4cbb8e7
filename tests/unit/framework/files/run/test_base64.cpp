#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "framework/files/run/base64.hpp"

namespace dda {
namespace {

TEST(Base64, PadsToGroupsOfFour) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("M"), "TQ==");
  EXPECT_EQ(base64("Ma"), "TWE=");
  EXPECT_EQ(base64("Man"), "TWFu");
  EXPECT_EQ(base64("Many"), "TWFueQ==");
}

TEST(Base64, EveryByteHasItsDigits) { EXPECT_EQ(base64(std::string("\x00\xFF\xFB\xEF\xBE", 5)), "AP/7774="); }

TEST(Base64, ArraysAreLittleEndian) {
  constexpr std::array<std::int16_t, 2> values = {1, -2};
  EXPECT_EQ(base64_of(std::span<const std::int16_t>(values)), "AQD+/w==");
}

}  // namespace
}  // namespace dda
