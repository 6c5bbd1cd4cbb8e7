#include <gmock/gmock.h>
#include <hdf5.h>

#include "framework/files/hdf5_file.hpp"
#include "framework/files/run_folder.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::Scratch;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A file that holds /a/x = (1, 2, 3).
std::filesystem::path small_file(const Scratch& scratch) {
  Hdf5File file = Hdf5File::in_memory();
  file.write("/a/x", std::vector<double>{1, 2, 3});
  write_whole(scratch / "f.h5", file.bytes());
  return scratch / "f.h5";
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

TEST(Hdf5File, SaysWhatIsMissing) {
  const Hdf5File file = Hdf5File::from_bytes(Hdf5File::in_memory().bytes());
  EXPECT_THROW(file.numbers("/x"), Hdf5Error);
  EXPECT_THROW(file.text_attribute("/", "x"), Hdf5Error);
  EXPECT_THROW(Hdf5File::from_bytes("no"), Hdf5Error);
}

TEST(Hdf5File, RefusesArraysThatCannotBeInIt) {
  const Scratch scratch;
  const auto path = small_file(scratch);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hsize_t extent = hsize_t{1} << 60, chunk = 1 << 10;
  const hid_t space = H5Screate_simple(1, &extent, nullptr), layout = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_chunk(layout, 1, &chunk);
  const hid_t set = H5Dcreate2(file, "huge", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, layout, H5P_DEFAULT);
  EXPECT_GE(set, 0);
  H5Dclose(set), H5Pclose(layout), H5Sclose(space), H5Fclose(file);
  EXPECT_THROW(Hdf5File::open(path).numbers("/huge"), Hdf5Error);
}

}  // namespace
}  // namespace dda
