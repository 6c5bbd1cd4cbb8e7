#include <gmock/gmock.h>

#include "framework/base/errors.hpp"
#include "framework/files/run/results_reader.hpp"
#include "framework/files/run/results_writer.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::message_of;
using test::Scratch;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

ResultsMesh two_blocks() {
  return {.blocks = {{{0, 0}, {1, 0}, {1, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}},
          .block_region = {0, 1},
          .segments = {{Vec2{1, 0}, Vec2{1, 1}}},
          .length_unit = "m"};
}

Snapshot stored_step(int step) {
  const double x = step;
  return {step,
          x,
          {},
          {{"displacement", "m", FieldPlace::block_vertex, 2, std::vector<double>(14, x), "x y"},
           {"damage", "", FieldPlace::segment, 1, {x / 10}, ""}}};
}

TEST(ResultsReader, ReadsWhatWasStored) {
  const Scratch scratch;
  ResultsWriter written(scratch.path(), two_blocks(), {{"version", "0.1"}});
  written.store(stored_step(3));
  written.store(stored_step(7));
  const ResultsReader results(scratch.path());
  EXPECT_THAT(results.steps(), ElementsAre(3, 7));
  EXPECT_EQ(results.mesh().blocks, two_blocks().blocks);
  EXPECT_EQ(results.mesh().segments, two_blocks().segments);
  EXPECT_EQ(results.mesh().block_region, two_blocks().block_region);
  EXPECT_EQ(results.mesh().length_unit, "m");
  EXPECT_EQ(results.values(7, "displacement").size(), 21u);
  EXPECT_THAT(results.values(7, "segments/damage"), ElementsAre(0.7));
  EXPECT_EQ(results.unit(7, "displacement"), "m");
  EXPECT_TRUE(results.has(3, "segments/damage"));
  EXPECT_FALSE(results.has(3, "stress"));
  EXPECT_EQ(results.provenance().at("version"), "0.1");
}

TEST(ResultsReader, TakesNothingElseForAStep) {
  const Scratch scratch;
  ResultsWriter written(scratch.path(), two_blocks(), {});
  written.store(stored_step(1000007));
  written.store(stored_step(1000008));
  for (const char* other : {"000009.h5.part", "9.h5", "-00009.h5", "000009 copy.h5", "99999999999.h5"})
    test::put(scratch / (std::string("fields/") + other), "");
  EXPECT_THAT(ResultsReader(scratch.path()).steps(), ElementsAre(1000007, 1000008));
}

TEST(ResultsReader, ReadsWhileAnotherStepIsWritten) {
  const Scratch scratch;
  ResultsWriter written(scratch.path(), two_blocks(), {});
  written.store(stored_step(3));
  const ResultsReader results(scratch.path());
  written.store(stored_step(7));
  EXPECT_THAT(results.steps(), ElementsAre(3));
  EXPECT_THAT(results.values(3, "segments/damage"), ElementsAre(0.3));
}

TEST(ResultsReader, SaysWhichFileItCannotRead) {
  const Scratch scratch;
  EXPECT_THAT(message_of<InputError>([&] { ResultsReader{scratch.path()}; }), HasSubstr(mesh_file));
  ResultsWriter(scratch.path(), two_blocks(), {}).store(stored_step(3));
  test::put(scratch / "fields/000003.h5", "this is no HDF5");
  const ResultsReader results(scratch.path());
  const std::string message = message_of<InputError>([&] { results.values(3, "displacement"); });
  EXPECT_THAT(message, HasSubstr("fields/000003.h5: cannot be read"));
  test::put(scratch / mesh_file, "this is no HDF5");
  EXPECT_THAT(message_of<InputError>([&] { ResultsReader{scratch.path()}; }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace dda
