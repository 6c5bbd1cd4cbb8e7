#include <gmock/gmock.h>
#include <sys/file.h>

#include <thread>

#include "framework/base/errors.hpp"
#include "framework/files/hdf5_file.hpp"
#include "framework/files/results_file.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::Scratch;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A triangle beside a square, with the interface between them.
ResultsMesh small_mesh() {
  ResultsMesh mesh;
  mesh.blocks = {{{0, 0}, {1, 0}, {1, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}};
  mesh.block_region = {0, 1};
  mesh.segments = {{Vec2{1, 0}, Vec2{1, 1}}};
  mesh.length_unit = "mm";
  return mesh;
}

Snapshot snapshot(int step) {
  const double x = step;
  return {step,
          0.1 * x,
          {{"load_factor", 2.0 * x}},
          {{"displacement", "mm", FieldPlace::block_vertex, 2, std::vector<double>(14, x), "x y"},
           {"stress", "MPa", FieldPlace::block, 3, {x, 2, 3, 4, 5, 6}, "xx yy xy"},
           {"damage", "", FieldPlace::segment, 1, {0.5}, ""}}};
}

Hdf5File reading(const ResultsFile& results) {
  return Hdf5File::open(results.path(), Hdf5File::Access::read);
}

TEST(ResultsFile, WritesTheMeshOnce) {
  const Scratch scratch;
  const ResultsFile results(scratch.path(), small_mesh(), {{"version", "0.1"}});
  const Hdf5File file = reading(results);
  EXPECT_THAT(file.integers("/mesh/mixed"), ElementsAre(3, 3, 0, 1, 2, 3, 4, 3, 4, 5, 6));
  EXPECT_THAT(file.integers("/mesh/offsets"), ElementsAre(0, 3, 7));
  EXPECT_EQ(file.num_rows("/mesh/vertices"), 7u);
  EXPECT_EQ(file.numbers("/mesh/vertices")[3 * 4], 2.0);
  EXPECT_EQ(file.text_attribute("/mesh/vertices", "unit"), "mm");
  EXPECT_THAT(file.texts("/provenance/version"), ElementsAre("0.1"));
}

TEST(ResultsFile, WritesTheTablesOfTheModel) {
  const Scratch scratch;
  ResultsMesh mesh = small_mesh();
  mesh.model = {{"side/ends", {1, 0, 1, 1}, {}, {}, 4},
                {"side/blocks", {}, {0, 1}, {}, 2},
                {"interface_names", {}, {}, {"joint"}, 1},
                {"load/block", {}, {}, {}, 1}};
  const ResultsFile results(scratch.path(), mesh, {});
  const Hdf5File file = reading(results);
  EXPECT_EQ(file.num_rows("/model/side/ends"), 1u);
  EXPECT_THAT(file.numbers("/model/side/ends"), ElementsAre(1, 0, 1, 1));
  EXPECT_THAT(file.integers("/model/side/blocks"), ElementsAre(0, 1));
  EXPECT_THAT(file.texts("/model/interface_names"), ElementsAre("joint"));
  EXPECT_EQ(file.num_rows("/model/load/block"), 0u) << "an empty table is there";
}

TEST(ResultsFile, StoresFieldsStepByStep) {
  const Scratch scratch;
  ResultsFile results(scratch.path(), small_mesh(), {});
  results.store(snapshot(3));
  results.store(snapshot(34));
  EXPECT_THAT(results.steps(), ElementsAre(3, 34));
  const Hdf5File file = reading(results);
  EXPECT_THAT(file.numbers("/field/000034/stress"), ElementsAre(34, 2, 3, 4, 5, 6));
  EXPECT_THAT(file.numbers("/field/000003/segments/damage"), ElementsAre(0.5));
  EXPECT_EQ(file.text_attribute("/field/000034/stress", "unit"), "MPa");
  EXPECT_EQ(file.text_attribute("/field/000034/stress", "components"), "xx yy xy");
  EXPECT_EQ(file.number_attribute("/field/000034", "load_factor"), 68.0);
  EXPECT_EQ(file.numbers("/field/000034/displacement").size(), 21u) << "two components are stored as three";
}

TEST(ResultsFile, RejectsFieldsThatDoNotFit) {
  const Scratch scratch;
  ResultsFile results(scratch.path(), small_mesh(), {});
  Snapshot wrong = snapshot(1);
  wrong.fields[1].values.pop_back();
  EXPECT_THROW(results.store(wrong), std::invalid_argument);
  results.store(snapshot(2));
  EXPECT_THROW(results.store(snapshot(2)), std::invalid_argument);
  EXPECT_THAT(results.steps(), ElementsAre(2));
}

TEST(ResultsFile, ProvenanceCanBeReplaced) {
  const Scratch scratch;
  ResultsFile results(scratch.path(), small_mesh(), {{"deck", "a: 1"}});
  results.set_provenance("wall_time", "1.5");
  results.set_provenance("wall_time", "2.5");
  EXPECT_THAT(reading(results).texts("/provenance/wall_time"), ElementsAre("2.5"));
  EXPECT_THAT(reading(results).texts("/provenance/deck"), ElementsAre("a: 1"));
}

TEST(ResultsFile, ResumeDropsLaterSteps) {
  const Scratch scratch;
  {
    ResultsFile results(scratch.path(), small_mesh(), {});
    for (int step = 1; step <= 4; ++step) results.store(snapshot(step));
  }
  ResultsFile results = ResultsFile::resume(scratch.path(), 2);
  EXPECT_THAT(results.steps(), ElementsAre(1, 2));
  results.store(snapshot(3));
  EXPECT_THAT(results.steps(), ElementsAre(1, 2, 3));
  EXPECT_THAT(reading(results).members("/field"), ElementsAre("000001", "000002", "000003"));
}

TEST(ResultsFile, ResumedFileDescribesItselfAsTheUninterrupted) {
  const Scratch scratch, other;
  {
    ResultsFile results(scratch.path(), small_mesh(), {});
    ResultsFile same(other.path(), small_mesh(), {});
    for (int step = 1; step <= 2; ++step) results.store(snapshot(step));
    for (int step = 1; step <= 2; ++step) same.store(snapshot(step));
  }
  ResultsFile::resume(scratch.path(), 2);
  const std::string text = test::content(scratch / "run.xdmf");
  EXPECT_EQ(text.size(), test::content(other / "run.xdmf").size());
  EXPECT_THAT(text, HasSubstr("run.h5:/field/000002/segments/damage"));
}

TEST(ResultsFile, ResumeNeedsAFile) {
  const Scratch scratch;
  ResultsFile results(scratch.path(), small_mesh(), {});
  test::put(results.path(), "not HDF5");
  EXPECT_THROW(ResultsFile::resume(scratch.path(), 1), InputError);
}

TEST(ResultsFile, FullDiskKeepsEarlierStepsReadable) {
  const Scratch scratch;
  ResultsFile results(scratch.path(), small_mesh(), {});
  results.store(snapshot(1));
  const auto size = std::filesystem::file_size(results.path());
  {
    const test::FileSizeLimit limit(size + 5000);
    const std::string message = test::message_of<OutputError>([&] { results.store(snapshot(2)); });
    EXPECT_THAT(message, HasSubstr("run.h5"));
    EXPECT_THAT(message, HasSubstr("File too large"));
  }
  EXPECT_EQ(std::filesystem::file_size(results.path()), size);
  EXPECT_THAT(reading(results).members("/field"), ElementsAre("000001"));
  EXPECT_THAT(test::content(scratch / "run.xdmf"), Not(HasSubstr("000002")));
  results.store(snapshot(2));
  EXPECT_THAT(results.steps(), ElementsAre(1, 2));
}

TEST(ResultsFile, CannotStartWhereNothingCanBeWritten) {
  const Scratch scratch;
  test::put(scratch / "file.txt", "x");
  EXPECT_THROW(ResultsFile(scratch / "file.txt", small_mesh(), {}), OutputError);
}

TEST(ResultsFile, WaitsForAReaderThatHoldsTheLock) {
  const Scratch scratch;
  ResultsFile results(scratch.path(), small_mesh(), {});
  const int descriptor = open(results.path().c_str(), O_RDONLY);
  ASSERT_EQ(flock(descriptor, LOCK_SH), 0);
  results.set_patience(std::chrono::milliseconds(20));
  EXPECT_THROW(results.store(snapshot(1)), OutputError);
  results.set_patience(std::chrono::seconds(10));
  std::thread reader([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    flock(descriptor, LOCK_UN);
  });
  EXPECT_NO_THROW(results.store(snapshot(1)));
  reader.join();
  close(descriptor);
}

TEST(ResultsFile, StepsStoredBeforeAKillStayReadable) {
  for (useconds_t pause = 3000; pause < 60000; pause += 1700) {
    const Scratch scratch;
    const int stored = test::kill_after(pause, [&](const auto& say) {
      ResultsFile results(scratch.path(), small_mesh(), {});
      for (int step = 1;; ++step) {
        results.store(snapshot(step));
        say(step);
      }
    });
    if (stored == 0) continue;
    const ResultsFile results = ResultsFile::resume(scratch.path(), stored);
    ASSERT_EQ(results.steps().size(), static_cast<std::size_t>(stored)) << "killed after " << pause << " µs";
    const Hdf5File file = reading(results);
    for (const std::string& step : file.members("/field")) {
      EXPECT_EQ(file.numbers("/field/" + step + "/stress").at(0), std::stod(step));
    }
  }
}

}  // namespace
}  // namespace dda
