#include <gtest/gtest.h>

#include <regex>
#include <vector>

#include "framework/messages/provenance.hpp"

namespace dda {
namespace {

TEST(Provenance, SaysWhereAResultComesFrom) {
  const auto texts = to_texts(provenance());
  for (const char* name : {"version", "compiler", "host", "date"})
    EXPECT_FALSE(texts.at(name).empty()) << name;
  EXPECT_TRUE(std::regex_search(texts.at("version"), std::regex(R"(^\d+\.\d+\.\d+)")));
}

TEST(Provenance, TimeIsIso8601) {
  EXPECT_TRUE(std::regex_match(utc_now(), std::regex(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z)")))
      << utc_now();
}

TEST(Provenance, PeakMemoryGrowsWithWhatIsHeld) {
  const double before = peak_memory_mib();
  const std::vector<char> large(200u << 20, 'x');
  EXPECT_GT(before, 1);
  EXPECT_GE(peak_memory_mib(), 200);
  EXPECT_EQ(large.back(), 'x');
}

}  // namespace
}  // namespace dda
