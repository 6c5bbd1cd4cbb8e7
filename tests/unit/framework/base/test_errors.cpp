#include <gmock/gmock.h>

#include "framework/base/errors.hpp"
#include "unit/framework/deck/messages.hpp"

namespace dda {
namespace {

TEST(Errors, PositionPrintsWhatIsKnown) {
  EXPECT_EQ(to_string(Position{"beam.yaml", 12, 5}), "beam.yaml:12:5");
  EXPECT_EQ(to_string(Position{"beam.yaml", 0, 0}), "beam.yaml");
  EXPECT_EQ(to_string(Position{}), "");
}

TEST(Errors, FindingsAreThrownTogetherInOrderOfPosition) {
  Findings findings;
  findings.add({"b.yaml", 10, 1}, "third");
  findings.add({"b.yaml", 9, 7}, "second");
  findings.add(InputError({"b.yaml", 9, 2}, "first"));
  EXPECT_EQ(messages([&] { findings.throw_if_any(); }),
            "b.yaml:9:2: first\nb.yaml:9:7: second\nb.yaml:10:1: third");
}

TEST(Errors, WhatAnAliasRepeatsIsToldOnce) {
  Findings findings;
  for (int i = 0; i < 3; ++i) {
    findings.add({"b.yaml", 9, 2}, "unknown key");
    findings.add({"b.yaml", 9, 2}, "no angle");
  }
  EXPECT_EQ(messages([&] { findings.throw_if_any(); }), "b.yaml:9:2: unknown key\nb.yaml:9:2: no angle");
}

TEST(Errors, TextStaysReadableForAnyNumberOfFindings) {
  Findings findings;
  for (int i = 0; i < 1000; ++i) findings.add({"a.yaml", i, 1}, std::string(5000, 'x'));
  try {
    findings.throw_if_any();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.findings().size(), 1000u);
    EXPECT_LT(std::string(error.what()).size(), 100000u);
    EXPECT_THAT(error.what(), ::testing::EndsWith("... and 970 more"));
  }
}

TEST(Errors, NothingFoundThrowsNothing) {
  Findings findings;
  EXPECT_TRUE(findings.empty());
  EXPECT_NO_THROW(findings.throw_if_any());
}

TEST(Errors, FindingWithoutPlaceHasNoColon) { EXPECT_STREQ(InputError(Position{}, "empty").what(), "empty"); }

}  // namespace
}  // namespace dda
