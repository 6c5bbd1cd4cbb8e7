#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "framework/base/errors.hpp"
#include "framework/files/run/hdf5_file.hpp"
#include "framework/files/run/restart_file.hpp"
#include "framework/files/whole_file.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::Scratch;
using ::testing::HasSubstr;

RestartData some_data() {
  RestartData data;
  data.numbers["state"] = {0.1, -0.0, 5e-324, std::numeric_limits<double>::infinity(), 1.0 / 3.0};
  data.numbers["empty"] = {};
  data.integers["steps"] = {0, -1, std::numeric_limits<std::int64_t>::max()};
  data.texts["names"] = {"first crack", "", "λ·d"};
  data.texts["none"] = {};
  return data;
}

TEST(RestartFile, ReadsBackBitForBit) {
  const Scratch scratch;
  RestartData data = some_data();
  data.numbers["nan"] = {std::nan("7")};
  write_restart(scratch / "r.h5", data);
  const RestartData read = read_restart(scratch / "r.h5");
  for (const auto& [name, values] : data.numbers) {
    ASSERT_EQ(read.numbers.at(name).size(), values.size());
    if (values.empty()) continue;
    EXPECT_EQ(std::memcmp(read.numbers.at(name).data(), values.data(), values.size() * sizeof(double)), 0)
        << name;
  }
  EXPECT_EQ(read.integers, data.integers);
  EXPECT_EQ(read.texts, data.texts);
}

TEST(RestartFile, EveryTruncationIsNoticed) {
  const Scratch scratch;
  write_restart(scratch / "r.h5", some_data());
  const std::string whole = test::content(scratch / "r.h5");
  for (std::size_t size = 0; size < whole.size(); size += 997) {
    test::put(scratch / "cut.h5", whole.substr(0, size));
    EXPECT_THAT(test::message_of<InputError>([&] { read_restart(scratch / "cut.h5"); }), HasSubstr("cut.h5"));
  }
}

TEST(RestartFile, AChangedValueIsNoticed) {
  const Scratch scratch;
  write_restart(scratch / "r.h5", some_data());
  std::string bytes = test::content(scratch / "r.h5");
  const double third = 1.0 / 3.0;
  const std::size_t place = bytes.find(std::string(reinterpret_cast<const char*>(&third), sizeof third));
  ASSERT_NE(place, std::string::npos);
  bytes[place] = static_cast<char>(bytes[place] ^ 1);
  test::put(scratch / "r.h5", bytes);
  EXPECT_THAT(test::message_of<InputError>([&] { read_restart(scratch / "r.h5"); }), HasSubstr("checksum"));
}

TEST(RestartFile, ForeignAndMissingFilesAreNamed) {
  const Scratch scratch;
  EXPECT_THROW(read_restart(scratch / "none.h5"), InputError);
  test::put(scratch / "text.h5", "hello, I am a text file");
  EXPECT_THROW(read_restart(scratch / "text.h5"), InputError);
  Hdf5File other = Hdf5File::in_memory();
  other.write("/x", std::vector<double>{1});
  write_whole(scratch / "other.h5", other.bytes());
  EXPECT_THAT(test::message_of<InputError>([&] { read_restart(scratch / "other.h5"); }),
              HasSubstr("another kind"));
}

TEST(RestartFile, FullDiskKeepsTheOldFile) {
  const Scratch scratch;
  write_restart(scratch / "r.h5", some_data());
  {
    const test::FileSizeLimit limit(4000);
    RestartData large;
    large.numbers["state"].assign(100000, 1.5);
    EXPECT_THROW(write_restart(scratch / "r.h5", large), OutputError);
  }
  EXPECT_EQ(read_restart(scratch / "r.h5"), some_data());
  EXPECT_FALSE(std::filesystem::exists(scratch / "r.h5.part"));
}

TEST(RestartFile, AKilledWriterLeavesAWholeFile) {
  const Scratch scratch;
  RestartData data;
  write_restart(scratch / "r.h5", data);
  for (useconds_t pause = 1000; pause < 12000; pause += 1000) {
    test::kill_after(pause, [&](const auto&) {
      for (double i = 0;; ++i) {
        RestartData next;
        next.numbers["state"].assign(20000, i);
        write_restart(scratch / "r.h5", next);
      }
    });
    EXPECT_NO_THROW(read_restart(scratch / "r.h5"));
  }
}

}  // namespace
}  // namespace dda
