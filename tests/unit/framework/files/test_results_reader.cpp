#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>

#include <thread>

#include "framework/base/errors.hpp"
#include "framework/files/hdf5_file.hpp"
#include "framework/files/results_reader.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::message_of;
using test::Scratch;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ResultsMesh small_mesh() {
  return {.blocks = {{{0, 0}, {1, 0}, {1, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}},
          .block_region = {0, 1},
          .segments = {{Vec2{1, 0}, Vec2{1, 1}}},
          .length_unit = "m"};
}

Snapshot snapshot(int step) {
  const double x = step;
  return {step,
          x,
          {},
          {{"displacement", "m", FieldPlace::block_vertex, 2, std::vector<double>(14, x), "x y"},
           {"damage", "", FieldPlace::segment, 1, {x / 10}, ""}}};
}

TEST(ResultsReader, ReadsWhatWasStored) {
  const Scratch scratch;
  ResultsFile written(scratch.path(), small_mesh(), {{"version", "0.1"}});
  written.store(snapshot(3));
  written.store(snapshot(7));
  const ResultsReader results(scratch.path());
  EXPECT_THAT(results.steps(), ElementsAre(3, 7));
  EXPECT_EQ(results.mesh().blocks, small_mesh().blocks);
  EXPECT_EQ(results.mesh().segments, small_mesh().segments);
  EXPECT_EQ(results.mesh().block_region, small_mesh().block_region);
  EXPECT_EQ(results.mesh().length_unit, "m");
  EXPECT_EQ(results.values(7, "displacement").size(), 21u);
  EXPECT_THAT(results.values(7, "segments/damage"), ElementsAre(0.7));
  EXPECT_EQ(results.unit(7, "displacement"), "m");
  EXPECT_TRUE(results.has(3, "segments/damage"));
  EXPECT_FALSE(results.has(3, "stress"));
  EXPECT_EQ(results.provenance().at("version"), "0.1");
}

TEST(ResultsReader, LeavesOutAStepThatWasCutShort) {
  const Scratch scratch;
  ResultsFile written(scratch.path(), small_mesh(), {});
  written.store(snapshot(3));
  Hdf5File file = Hdf5File::open(written.path(), Hdf5File::Access::append);
  file.make_group("/field/000007");
  file.set_attribute("/field/000007", "step", std::int64_t{7});
  file.close();
  EXPECT_THAT(ResultsReader(scratch.path()).steps(), ElementsAre(3));
}

TEST(ResultsReader, WaitsForAWriter) {
  const Scratch scratch;
  ResultsFile written(scratch.path(), small_mesh(), {});
  written.store(snapshot(3));
  const int descriptor = ::open(written.path().c_str(), O_RDWR);
  ASSERT_EQ(flock(descriptor, LOCK_EX | LOCK_NB), 0);
  std::thread writer([&] {
    usleep(50000);
    close(descriptor);
  });
  EXPECT_THAT(ResultsReader(scratch.path()).steps(), ElementsAre(3));
  writer.join();
}

TEST(ResultsReader, SaysWhichFileItCannotRead) {
  const Scratch scratch;
  EXPECT_THAT(message_of<InputError>([&] { ResultsReader{scratch.path()}; }), HasSubstr("run.h5"));
  test::put(scratch / "run.h5", "this is no HDF5");
  EXPECT_THAT(message_of<InputError>([&] { ResultsReader{scratch.path()}; }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace dda
