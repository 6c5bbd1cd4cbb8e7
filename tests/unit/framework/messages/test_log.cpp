#include <gtest/gtest.h>

#include <sstream>

#include "framework/base/errors.hpp"
#include "framework/messages/log.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::Scratch;

std::vector<nlohmann::json> lines_of(const std::filesystem::path& path) {
  std::istringstream stream(test::content(path));
  std::vector<nlohmann::json> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

TEST(Log, OneFlushedObjectPerLine) {
  const Scratch scratch;
  Log log(scratch / "log.jsonl");
  log.info("step", {{"number", 3}, {"load_factor", 0.5}});
  log.warning("text", {{"what", "two\nlines \"quoted\" \xff"}});
  const auto lines = lines_of(scratch / "log.jsonl");
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0]["event"], "step");
  EXPECT_EQ(lines[0]["level"], "info");
  EXPECT_EQ(lines[0]["load_factor"], 0.5);
  EXPECT_EQ(lines[0]["time"].get<std::string>().size(), 24u);
  EXPECT_EQ(lines[1]["level"], "warning");
}

TEST(Log, FieldsDoNotReplaceTheEvent) {
  const Scratch scratch;
  Log(scratch / "log.jsonl").error("stop", {{"event", "other"}, {"level", "info"}});
  const auto lines = lines_of(scratch / "log.jsonl");
  EXPECT_EQ(lines.at(0)["event"], "stop");
  EXPECT_EQ(lines.at(0)["level"], "error");
}

TEST(Log, AppendsOnResumeAndDiscardsByDefault) {
  const Scratch scratch;
  Log(scratch / "log.jsonl").info("first");
  Log(scratch / "log.jsonl", FileWriter::Mode::append).info("second");
  EXPECT_EQ(lines_of(scratch / "log.jsonl").size(), 2u);
  Log().info("nowhere");
}

TEST(Log, FullDiskIsAnError) { EXPECT_THROW(Log("/dev/full").info("x"), OutputError); }

}  // namespace
}  // namespace dda
