#include <gtest/gtest.h>

#include "continuation/control/step_kind.hpp"

namespace dda {
namespace {

TEST(StepKind, NamesAreReadBack) {
  for (int i = 0; i <= static_cast<int>(StepKind::jump); ++i) {
    const auto kind = static_cast<StepKind>(i);
    EXPECT_EQ(step_kind(to_string(kind)), kind) << to_string(kind);
  }
  EXPECT_EQ(to_string(StepKind::arc_length), "arc_length");
  EXPECT_EQ(to_string(StepKind::jump), "jump");
  EXPECT_FALSE(step_kind("staged"));
}

}  // namespace
}  // namespace dda
