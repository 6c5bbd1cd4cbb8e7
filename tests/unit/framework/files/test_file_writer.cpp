#include <gmock/gmock.h>

#include "framework/base/errors.hpp"
#include "framework/files/file_writer.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::Scratch;

TEST(FileWriter, EachPieceIsInTheFileAtOnce) {
  const Scratch scratch;
  FileWriter writer(scratch / "a", FileWriter::Mode::create);
  writer.write("one");
  EXPECT_EQ(test::content(scratch / "a"), "one");
  writer.write("two");
  EXPECT_EQ(test::content(scratch / "a"), "onetwo");
}

TEST(FileWriter, AppendsOrStartsAfresh) {
  const Scratch scratch;
  test::put(scratch / "a", "old");
  FileWriter(scratch / "a", FileWriter::Mode::append).write("+new");
  EXPECT_EQ(test::content(scratch / "a"), "old+new");
  FileWriter(scratch / "a", FileWriter::Mode::create).write("new");
  EXPECT_EQ(test::content(scratch / "a"), "new");
}

TEST(FileWriter, FullDeviceIsReportedWithItsReason) {
  FileWriter writer("/dev/full", FileWriter::Mode::append);
  const std::string message = test::message_of<OutputError>([&] { writer.write("x"); });
  EXPECT_THAT(message, testing::AllOf(testing::HasSubstr("/dev/full"), testing::HasSubstr("No space left")));
}

TEST(FileWriter, APieceIsWrittenWholeOrNotAtAll) {
  const Scratch scratch;
  FileWriter writer(scratch / "a", FileWriter::Mode::create);
  writer.write(std::string(600, 'a'));
  {
    const test::FileSizeLimit limit(1000);
    EXPECT_THROW(writer.write(std::string(600, 'b')), OutputError);
  }
  EXPECT_EQ(test::content(scratch / "a"), std::string(600, 'a'));
}

}  // namespace
}  // namespace dda
