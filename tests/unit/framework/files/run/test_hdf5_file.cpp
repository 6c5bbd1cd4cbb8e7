#include <gmock/gmock.h>
#include <hdf5.h>
#include <sys/stat.h>

#include "framework/base/errors.hpp"
#include "framework/files/run/hdf5_file.hpp"
#include "framework/files/whole_file.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::Scratch;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A file that holds /a/x = (1, 2, 3).
Hdf5File small_file() {
  Hdf5File file = Hdf5File::in_memory();
  file.write("/a/x", std::vector<double>{1, 2, 3});
  return file;
}

TEST(Hdf5File, KeepsArraysTextsAndAttributes) {
  Hdf5File file = Hdf5File::in_memory();
  file.write("/a/b/x", std::vector<double>{1, 2, 3, 4, 5, 6}, 3);
  file.write("/a/n", std::vector<std::int64_t>{});
  file.write("/a/t", std::vector<std::string>{"λ", ""});
  file.set_attribute("/a", "number", 0.1);
  file.set_attribute("/a", "number", 0.2);
  const Hdf5File copy = Hdf5File::from_bytes(file.bytes());
  EXPECT_THAT(copy.numbers("/a/b/x"), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(copy.num_rows("/a/b/x"), 2u);
  EXPECT_THAT(copy.integers("/a/n"), IsEmpty());
  EXPECT_THAT(copy.texts("/a/t"), ElementsAre("λ", ""));
  EXPECT_THAT(copy.members("/a"), ElementsAre("b", "n", "t"));
  EXPECT_EQ(copy.number_attribute("/a", "number"), 0.2);
  EXPECT_FALSE(copy.has("/none/x"));
}

TEST(Hdf5File, ViewsAreColumnsOfOtherArraysOrZero) {
  Hdf5File file = Hdf5File::in_memory();
  file.write("/a/x", std::vector<double>{1, 2, 3, 4, 5, 6}, 3);
  file.write("/y", std::vector<double>{7, 8});
  file.write_view("/a/both", 4, {{"/a/x", 2, 0}, {"/y", 0, 1}, {"/a/x", 0, 3}});
  file.write_view("/middle", 1, {{"/a/x", 1, 0}});
  const Hdf5File copy = Hdf5File::from_bytes(file.bytes());
  EXPECT_THAT(copy.numbers("/a/both"), ElementsAre(3, 7, 0, 1, 6, 8, 0, 4));
  EXPECT_EQ(copy.num_rows("/a/both"), 2u);
  EXPECT_THAT(copy.numbers("/middle"), ElementsAre(2, 5));
}

TEST(Hdf5File, NamesItsAttributes) {
  Hdf5File file = small_file();
  file.set_attribute("/", "time", 0.5);
  file.set_attribute("/", "load [kN]", 1.5);
  file.set_attribute("/a", "of a group", 1.0);
  EXPECT_THAT(Hdf5File::from_bytes(file.bytes()).attributes("/"), ElementsAre("load [kN]", "time"));
  EXPECT_THAT(file.attributes("/a/x"), IsEmpty());
}

TEST(Hdf5File, SaysWhatIsMissing) {
  const Hdf5File file = Hdf5File::from_bytes(Hdf5File::in_memory().bytes());
  EXPECT_THROW(file.numbers("/x"), Hdf5Error);
  EXPECT_THROW(file.text_attribute("/", "x"), Hdf5Error);
  EXPECT_THROW(Hdf5File::from_bytes("no"), Hdf5Error);
}

/// HDF5 itself may loop for ever in a file with a single wrong bit.
TEST(Hdf5File, OpensNothingDamaged) {
  const Scratch scratch;
  const std::string whole = small_file().bytes();
  const auto is_refused = [&](const std::string& bytes) {
    test::put(scratch / "f.h5", bytes);
    EXPECT_THROW(Hdf5File::open(scratch / "f.h5"), Hdf5Error);
    EXPECT_THROW(Hdf5File::from_bytes(bytes), Hdf5Error);
  };
  for (std::size_t place = 0; place < whole.size(); place += place < whole.size() - 40 ? 13 : 1) {
    std::string changed = whole;
    changed[place] = static_cast<char>(changed[place] ^ (1 << place % 8));
    is_refused(changed);
    is_refused(whole.substr(0, place));
  }
  is_refused(whole + "\n");
}

TEST(Hdf5File, ReadsWhatIsSealed) {
  const Scratch scratch;
  write_whole(scratch / "f.h5", small_file().bytes());
  EXPECT_THAT(Hdf5File::open(scratch / "f.h5").numbers("/a/x"), ElementsAre(1, 2, 3));
  const hid_t other = H5Fopen((scratch / "f.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  EXPECT_GE(other, 0) << "other programs do not mind the seal";
  H5Fclose(other);
}

TEST(Hdf5File, WaitsForNoPipe) {
  const Scratch scratch;
  ASSERT_EQ(mkfifo((scratch / "pipe.h5").c_str(), 0600), 0);
  EXPECT_THAT(test::message_of<InputError>([&] { Hdf5File::open(scratch / "pipe.h5"); }),
              ::testing::HasSubstr("pipe.h5"));
}

}  // namespace
}  // namespace dda
