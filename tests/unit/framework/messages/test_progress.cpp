#include <gmock/gmock.h>

#include <algorithm>

#include "framework/messages/progress.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

ProgressPoint some_point() {
  return {34, 0.8125, "dissipation", {{"cmod", 0.0123}, {"deflection", 0.5}}, 3, 1e-3, 0.42};
}

std::size_t characters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// What Progress writes to a file in this style.
std::string shown(Progress::Style style) {
  const test::Scratch scratch;
  std::FILE* file = std::fopen((scratch / "out").c_str(), "w");
  {
    Progress progress(file, style);
    progress.show(some_point());
    progress.note("limit point");
    ProgressPoint next = some_point();
    next.step = 35;
    progress.show(next);
  }
  std::fclose(file);
  return test::content(scratch / "out");
}

TEST(ProgressLine, ShowsEverythingWhereThereIsRoom) {
  const std::string line = progress_line(some_point(), 200);
  for (const char* part :
       {"34", "0.8125", "dissipation", "cmod 0.0123", "deflection 0.5", "3 it.", "0.001", "42%", "####..."}) {
    EXPECT_THAT(line, HasSubstr(part));
  }
}

TEST(ProgressLine, NeverExceedsTheWidthAndDropsGaugesFirst) {
  for (std::size_t width = 0; width < 130; ++width)
    EXPECT_LE(characters(progress_line(some_point(), width)), width);
  const std::string narrow = progress_line(some_point(), 66);
  EXPECT_THAT(narrow, HasSubstr("3 it."));
  EXPECT_THAT(narrow, HasSubstr("42%"));
  EXPECT_THAT(narrow, Not(HasSubstr("deflection")));
}

TEST(ProgressLine, NoBarWithoutAGoalAndNoneBeyondItsEnds) {
  ProgressPoint point = some_point();
  point.goal = std::nan("");
  EXPECT_THAT(progress_line(point, 200), Not(HasSubstr("%")));
  point.goal = 1.7;
  EXPECT_THAT(progress_line(point, 200), HasSubstr("[##########] 100%"));
  point.goal = -1;
  point.step = 30;
  EXPECT_THAT(progress_line(point, 200), HasSubstr("[>.........]   0%"));
}

TEST(ProgressLine, AMarkMovesWhileNothingOfTheWayIsDone) {
  ProgressPoint point = some_point();
  point.goal = 0;
  point.step = 37;
  EXPECT_THAT(progress_line(point, 200), HasSubstr("[.......>..]   0%"));
  point.goal = 0.1;
  EXPECT_THAT(progress_line(point, 200), HasSubstr("[#.........]  10%"));
}

TEST(ProgressLine, TimeStandsAtItsEnd) {
  ProgressPoint point = some_point();
  point.seconds = 75;
  EXPECT_THAT(progress_line(point, 200), EndsWith("42%  0:01:15"));
  EXPECT_LE(characters(progress_line(point, 40)), 40);
}

TEST(DurationText, HasHoursFromAMinuteOn) {
  EXPECT_EQ(duration_text(0.04), "0.0 s");
  EXPECT_EQ(duration_text(59.9), "59.9 s");
  EXPECT_EQ(duration_text(185), "0:03:05");
  EXPECT_EQ(duration_text(3727), "1:02:07");
}

TEST(Progress, LiveRenewsOneLine) {
  const std::string text = shown(Progress::Style::live);
  EXPECT_EQ(text.front(), '\r');
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2);  // the note and the end
  EXPECT_THAT(text, HasSubstr("\rlimit point\n\r"));
}

TEST(Progress, PlainLinesElsewhere) {
  const std::string text = shown(Progress::Style::lines);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

TEST(Progress, QuietSaysNothing) { EXPECT_EQ(shown(Progress::Style::quiet), ""); }

}  // namespace
}  // namespace dda
