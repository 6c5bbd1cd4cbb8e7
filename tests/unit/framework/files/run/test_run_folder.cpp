#include <gmock/gmock.h>

#include <array>
#include <functional>

#include "framework/base/errors.hpp"
#include "framework/files/run/run_folder.hpp"
#include "framework/files/whole_file.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using test::Scratch;
using ::testing::HasSubstr;

TEST(RunFolder, TakesTheNextFreeNumber) {
  const Scratch scratch;
  for (const char* expected : {"beam", "beam-2", "beam-3"}) {
    const RunFolder folder = RunFolder::create(scratch / "runs/beam", IfExists::number);
    EXPECT_EQ(folder.path(), scratch / "runs" / expected);
    test::put(folder.file("curve.csv"), "x");
  }
}

TEST(RunFolder, UsesAnEmptyFolderAndForgivesATrailingSlash) {
  const Scratch scratch;
  fs::create_directories(scratch / "beam");
  EXPECT_EQ(RunFolder::create(scratch / "beam/", IfExists::number).path(), scratch / "beam");
}

TEST(RunFolder, BelongsToOneRunAtATime) {
  const Scratch scratch;
  const fs::path path = scratch / "run";
  {
    const RunFolder folder = RunFolder::create(path, IfExists::refuse);
    for (const auto& again : {std::function([&] { RunFolder::create(path, IfExists::overwrite); }),
                              std::function([&] { RunFolder::open(path); })})
      EXPECT_THAT(test::message_of<InputError>(again), HasSubstr("another run is at work"));
    EXPECT_EQ(RunFolder::create(scratch / "other", IfExists::number).path(), scratch / "other");
  }
  EXPECT_EQ(RunFolder::open(path).path(), path);
}

TEST(RunFolder, RefusesAFolderThatHoldsSomething) {
  const Scratch scratch;
  test::put(scratch / "mine.txt", "keep");
  const std::string message =
      test::message_of<OutputError>([&] { RunFolder::create(scratch.path(), IfExists::refuse); });
  EXPECT_THAT(message, HasSubstr(scratch.path().string()));
  EXPECT_THAT(message, HasSubstr("not empty"));
}

TEST(RunFolder, OverwritingRemovesOnlyFilesOfARun) {
  const Scratch scratch;
  test::put(scratch / "mine.txt", "keep");
  test::put(scratch / "mesh.h5", "keep");
  fs::create_directory(scratch / "fields");
  const std::array old{"run.xdmf", "curve.csv.part", "fields/mesh.h5", "fields/000034.h5"};
  for (const char* file : old) test::put(scratch / file, "old");
  test::put(scratch / "fields/mine.h5", "keep");
  RunFolder::create(scratch.path(), IfExists::overwrite);
  for (const char* file : {"mine.txt", "mesh.h5", "fields/mine.h5"}) EXPECT_TRUE(fs::exists(scratch / file));
  for (const char* file : old) EXPECT_FALSE(fs::exists(scratch / file)) << file;
  fs::remove(scratch / "fields/mine.h5");
  RunFolder::create(scratch.path(), IfExists::overwrite);
  EXPECT_FALSE(fs::exists(scratch / "fields"));
}

TEST(RunFolder, OverwritingForgetsTheBranchThatAnEarlierRunLeft) {
  const Scratch scratch;
  fs::create_directories(scratch / "run/primary");
  test::put(scratch / "run/primary/summary.json", "{}");
  RunFolder::create(scratch / "run", IfExists::overwrite);
  EXPECT_FALSE(fs::exists(scratch / "run/primary"));
  fs::create_directories(scratch / "run/primary");
  test::put(scratch / "run/primary/mine.txt", "kept");
  test::put(scratch / "run/primary/summary.json", "{}");
  RunFolder::create(scratch / "run", IfExists::overwrite);
  EXPECT_TRUE(fs::exists(scratch / "run/primary/mine.txt"));
  EXPECT_FALSE(fs::exists(scratch / "run/primary/summary.json"));
}

TEST(RunFolder, SaysWhyAPlaceCannotBeWrittenAndLeavesNothing) {
  const Scratch scratch;
  test::put(scratch / "file.txt", "a file, not a folder");
  for (const IfExists policy : {IfExists::number, IfExists::refuse, IfExists::overwrite}) {
    const std::string message =
        test::message_of<OutputError>([&] { RunFolder::create(scratch / "file.txt/run", policy); });
    EXPECT_THAT(message, HasSubstr("file.txt/run"));
    EXPECT_THAT(message, HasSubstr("Not a directory"));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), fs::directory_iterator()), 1);
}

TEST(RunFolder, FullDiskLeavesNoFolders) {
  const Scratch scratch;
  const test::FileSizeLimit limit(0);
  EXPECT_THROW(RunFolder::create(scratch / "a/b/c", IfExists::refuse), OutputError);
  EXPECT_FALSE(fs::exists(scratch / "a"));
}

TEST(RunFolder, OpeningNeedsAFolder) {
  const Scratch scratch;
  EXPECT_THROW(RunFolder::open(scratch / "none"), InputError);
  EXPECT_EQ(RunFolder::open(scratch.path()).file("run.xdmf"), scratch / "run.xdmf");
}

TEST(DefaultRunFolder, IsNamedAfterTheDeckOrItsFolder) {
  EXPECT_EQ(default_run_folder("studies/notched-beam/deck.yaml"), "runs/notched-beam");
  EXPECT_EQ(default_run_folder("/some/where/beam.yaml"), "runs/beam");
}

TEST(WriteWhole, ReplacesTheFile) {
  const Scratch scratch;
  write_whole(scratch / "a.txt", "old");
  write_whole(scratch / "a.txt", "new");
  EXPECT_EQ(read_whole(scratch / "a.txt"), "new");
  EXPECT_FALSE(fs::exists(scratch / "a.txt.part"));
}

TEST(WriteWhole, FullDiskKeepsTheOldFileAndNoHalfOne) {
  const Scratch scratch;
  write_whole(scratch / "a.txt", "old");
  const test::FileSizeLimit limit(1000);
  const std::string message =
      test::message_of<OutputError>([&] { write_whole(scratch / "a.txt", std::string(5000, 'x')); });
  EXPECT_THAT(message, HasSubstr("a.txt"));
  EXPECT_THAT(message, HasSubstr("File too large"));
  EXPECT_EQ(read_whole(scratch / "a.txt"), "old");
  EXPECT_FALSE(fs::exists(scratch / "a.txt.part"));
}

TEST(ReadWhole, NamesTheMissingFile) {
  const std::string message = test::message_of<InputError>([] { read_whole("/nowhere/beam.yaml"); });
  EXPECT_THAT(message, HasSubstr("/nowhere/beam.yaml"));
  EXPECT_THROW(read_whole("/tmp"), InputError);
}

}  // namespace
}  // namespace dda
