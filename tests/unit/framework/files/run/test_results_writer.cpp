#include <gmock/gmock.h>

#include <algorithm>

#include "framework/base/errors.hpp"
#include "framework/files/run/hdf5_file.hpp"
#include "framework/files/run/results_writer.hpp"
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
  mesh.region_names = {"left", "right (concrete)"};
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

Hdf5File reading(const Scratch& scratch, const std::string& file) { return Hdf5File::open(scratch / file); }

/// What stands in the folder of the fields, in alphabetical order.
std::vector<std::string> field_files(const Scratch& scratch) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(scratch / fields_folder))
    names.push_back(entry.path().filename());
  std::ranges::sort(names);
  return names;
}

TEST(ResultsWriter, WritesTheMeshOnce) {
  const Scratch scratch;
  const ResultsWriter results(scratch.path(), small_mesh(), {{"version", "0.1"}});
  EXPECT_THAT(field_files(scratch), ElementsAre("mesh.h5"));
  const Hdf5File file = reading(scratch, mesh_file);
  EXPECT_THAT(file.integers("/mesh/mixed"), ElementsAre(3, 3, 0, 1, 2, 3, 4, 3, 4, 5, 6));
  EXPECT_THAT(file.integers("/mesh/offsets"), ElementsAre(0, 3, 7));
  EXPECT_EQ(file.num_rows("/mesh/vertices"), 7u);
  EXPECT_EQ(file.numbers("/mesh/vertices")[3 * 4], 2.0);
  EXPECT_EQ(file.text_attribute("/mesh/vertices", "unit"), "mm");
  EXPECT_THAT(file.texts("/mesh/region_names"), ElementsAre("left", "right (concrete)"));
  EXPECT_THAT(file.texts("/provenance/version"), ElementsAre("0.1"));
}

TEST(ResultsWriter, WritesTheTablesOfTheModel) {
  const Scratch scratch;
  ResultsMesh mesh = small_mesh();
  mesh.model = {{"side/ends", {1, 0, 1, 1}, {}, {}, 4},
                {"side/blocks", {}, {0, 1}, {}, 2},
                {"interface_names", {}, {}, {"joint"}, 1},
                {"load/block", {}, {}, {}, 1}};
  const ResultsWriter results(scratch.path(), mesh, {});
  const Hdf5File file = reading(scratch, mesh_file);
  EXPECT_EQ(file.num_rows("/model/side/ends"), 1u);
  EXPECT_THAT(file.numbers("/model/side/ends"), ElementsAre(1, 0, 1, 1));
  EXPECT_THAT(file.integers("/model/side/blocks"), ElementsAre(0, 1));
  EXPECT_THAT(file.texts("/model/interface_names"), ElementsAre("joint"));
  EXPECT_EQ(file.num_rows("/model/load/block"), 0u) << "an empty table is there";
}

TEST(ResultsWriter, StoresFieldsStepByStep) {
  const Scratch scratch;
  ResultsWriter results(scratch.path(), small_mesh(), {});
  results.store(snapshot(3));
  results.store(snapshot(34));
  EXPECT_THAT(results.steps(), ElementsAre(3, 34));
  EXPECT_THAT(field_files(scratch), ElementsAre("000003.h5", "000034.h5", "mesh.h5"));
  const Hdf5File file = reading(scratch, "fields/000034.h5");
  EXPECT_THAT(file.numbers("/stress"), ElementsAre(34, 2, 3, 4, 5, 6));
  EXPECT_THAT(file.numbers("/segments/damage"), ElementsAre(0.5));
  EXPECT_EQ(file.text_attribute("/stress", "unit"), "MPa");
  EXPECT_EQ(file.text_attribute("/stress", "components"), "xx yy xy");
  EXPECT_EQ(file.integer_attribute("/", "step"), 34);
  EXPECT_EQ(file.number_attribute("/", "load_factor"), 68.0);
  EXPECT_EQ(file.numbers("/displacement").size(), 21u) << "two components are stored as three";
}

/// Symmetric, of shear strains half of 2xy; normal and sliding components each by itself.
TEST(ResultsWriter, ShowsTensorsAndComponents) {
  const Scratch scratch;
  Snapshot here = snapshot(3);
  here.fields.push_back({"strain", "", FieldPlace::block, 3, {1, 2, 3, 4, 5, 6}, "xx yy 2xy"});
  here.fields.push_back({"opening", "mm", FieldPlace::segment, 2, {0.1, -0.2}, "n s"});
  here.fields.insert(here.fields.begin(), {"stress_zz", "MPa", FieldPlace::block, 1, {7, 8}, ""});
  ResultsWriter(scratch.path(), small_mesh(), {}).store(here);
  const Hdf5File file = reading(scratch, "fields/000003.h5");
  EXPECT_THAT(file.numbers("/stress_tensor"),
              ElementsAre(3, 3, 0, 3, 2, 0, 0, 0, 7, 4, 6, 0, 6, 5, 0, 0, 0, 8));
  EXPECT_THAT(file.numbers("/strain_tensor"),
              ElementsAre(1, 1.5, 0, 1.5, 2, 0, 0, 0, 0, 4, 3, 0, 3, 5, 0, 0, 0, 0));
  EXPECT_THAT(file.numbers("/segments/opening_n"), ElementsAre(0.1));
  EXPECT_THAT(file.numbers("/segments/opening_s"), ElementsAre(-0.2));
  EXPECT_FALSE(file.has_attribute("/stress_tensor", "place")) << "no field of its own";
  EXPECT_THAT(test::content(scratch / "run.xdmf"), HasSubstr("fields/000003.h5:/strain_tensor"));
}

/// The square cut in two, with a piece of a crack between its parts.
Snapshot cut_snapshot(int step) {
  Snapshot out = snapshot(step);
  out.cut = {.parts = {{{1, 0}, {1.5, 0}, {1.5, 1}, {1, 1}}, {{1.5, 0}, {2, 0}, {2, 1}, {1.5, 1}}},
             .part_block = {1, 1},
             .pieces = {{Vec2{1.5, 0}, Vec2{1.5, 1}}},
             .tables = {{"cracks/crack", {}, {0}, {}, 1}, {"parts/moves", {}, {1, 0}, {}, 2}}};
  out.fields.push_back({"displacement", "mm", FieldPlace::part_vertex, 2, std::vector<double>(16, 1), "x y"});
  out.fields.push_back({"damage", "", FieldPlace::crack, 1, {0.25}, ""});
  return out;
}

TEST(ResultsWriter, StoresWhatCracksHaveCut) {
  const Scratch scratch;
  ResultsWriter results(scratch.path(), small_mesh(), {});
  results.store(snapshot(3));
  results.store(cut_snapshot(34));
  const Hdf5File file = reading(scratch, "fields/000034.h5");
  EXPECT_THAT(file.integers("/parts/block"), ElementsAre(1, 1));
  EXPECT_THAT(file.integers("/parts/region"), ElementsAre(1, 1));
  EXPECT_THAT(file.integers("/parts/mixed"), ElementsAre(3, 4, 0, 1, 2, 3, 3, 4, 4, 5, 6, 7));
  EXPECT_THAT(file.integers("/parts/whole"), ElementsAre(3, 3, 0, 1, 2, 3, 3, 3, 3, 3))
      << "the triangle as it is, of the square its first vertex";
  EXPECT_THAT(file.integers("/parts/moves"), ElementsAre(1, 0));
  EXPECT_THAT(file.numbers("/cracks/ends"), ElementsAre(1.5, 0, 0, 1.5, 1, 0));
  EXPECT_THAT(file.integers("/cracks/crack"), ElementsAre(0));
  EXPECT_THAT(file.numbers("/cracks/damage"), ElementsAre(0.25));
  EXPECT_EQ(file.num_rows("/parts/displacement"), 8u);
  EXPECT_FALSE(reading(scratch, "fields/000003.h5").has("/parts"));
}

TEST(ResultsWriter, KnowsTheCutsOfAnEarlierRun) {
  const Scratch scratch;
  {
    ResultsWriter results(scratch.path(), small_mesh(), {});
    results.store(cut_snapshot(2));
    results.store(snapshot(3));
  }
  const std::string before = test::content(scratch / "run.xdmf");
  EXPECT_THAT(before, HasSubstr("fields/000002.h5:/parts/displacement"));
  ResultsWriter results = ResultsWriter::resume(scratch.path(), 3);
  EXPECT_EQ(test::content(scratch / "run.xdmf"), before);
  results.store(cut_snapshot(4));
  EXPECT_EQ(reading(scratch, "fields/000004.h5").num_rows("/parts/whole"), 10u);
}

TEST(ResultsWriter, RejectsFieldsThatDoNotFitTheParts) {
  const Scratch scratch;
  ResultsWriter results(scratch.path(), small_mesh(), {});
  Snapshot wrong = cut_snapshot(1);
  wrong.fields.back().values.push_back(1);
  EXPECT_THROW(results.store(wrong), std::invalid_argument);
  EXPECT_THAT(field_files(scratch), ElementsAre("mesh.h5"));
}

TEST(ResultsWriter, RejectsFieldsThatDoNotFit) {
  const Scratch scratch;
  ResultsWriter results(scratch.path(), small_mesh(), {});
  Snapshot wrong = snapshot(1);
  wrong.fields[1].values.pop_back();
  EXPECT_THROW(results.store(wrong), std::invalid_argument);
  results.store(snapshot(2));
  EXPECT_THROW(results.store(snapshot(2)), std::invalid_argument);
  EXPECT_THAT(results.steps(), ElementsAre(2));
}

TEST(ResultsWriter, ResumeDropsLaterSteps) {
  const Scratch scratch;
  {
    ResultsWriter results(scratch.path(), small_mesh(), {});
    for (int step = 1; step <= 4; ++step) results.store(snapshot(step));
  }
  test::put(scratch / "fields/000005.h5.part", "half a step");
  test::put(scratch / "fields/notes.txt", "the user's");
  ResultsWriter results = ResultsWriter::resume(scratch.path(), 2);
  EXPECT_THAT(results.steps(), ElementsAre(1, 2));
  EXPECT_THAT(test::content(scratch / "run.xdmf"), Not(HasSubstr("000003")));
  EXPECT_THAT(field_files(scratch), ElementsAre("000001.h5", "000002.h5", "mesh.h5", "notes.txt"));
  results.store(snapshot(3));
  EXPECT_THAT(results.steps(), ElementsAre(1, 2, 3));
}

TEST(ResultsWriter, AResumedRunDescribesItselfAsTheUninterrupted) {
  const Scratch scratch, other;
  {
    ResultsWriter results(scratch.path(), small_mesh(), {});
    ResultsWriter same(other.path(), small_mesh(), {});
    for (int step = 1; step <= 2; ++step) results.store(snapshot(step));
    for (int step = 1; step <= 2; ++step) same.store(snapshot(step));
  }
  ResultsWriter::resume(scratch.path(), 2);
  const std::string text = test::content(scratch / "run.xdmf");
  EXPECT_EQ(text.size(), test::content(other / "run.xdmf").size());
  EXPECT_THAT(text, HasSubstr("fields/000002.h5:/segments/damage"));
  EXPECT_THAT(text, HasSubstr("Name=\"load_factor\" AttributeType=\"Scalar\" Center=\"Grid\""));
  EXPECT_THAT(text, HasSubstr("Name=\"region 1: right (concrete)\""));
}

TEST(ResultsWriter, ResumeNeedsWholeFiles) {
  for (const char* damaged : {mesh_file, "fields/000001.h5"}) {
    const Scratch scratch;
    ResultsWriter(scratch.path(), small_mesh(), {}).store(snapshot(1));
    test::put(scratch / damaged, "not HDF5");
    EXPECT_THAT(test::message_of<InputError>([&] { ResultsWriter::resume(scratch.path(), 1); }),
                HasSubstr(damaged));
  }
  EXPECT_THROW(ResultsWriter::resume(Scratch().path(), 1), InputError);
}

TEST(ResultsWriter, FullDiskKeepsEarlierStepsReadable) {
  const Scratch scratch;
  ResultsWriter results(scratch.path(), small_mesh(), {});
  results.store(snapshot(1));
  const std::string first = test::content(scratch / "fields/000001.h5");
  {
    const test::FileSizeLimit limit(first.size() - 100);
    const std::string message = test::message_of<OutputError>([&] { results.store(snapshot(2)); });
    EXPECT_THAT(message, HasSubstr("fields/000002.h5"));
    EXPECT_THAT(message, HasSubstr("File too large"));
  }
  EXPECT_THAT(field_files(scratch), ElementsAre("000001.h5", "mesh.h5"));
  EXPECT_EQ(test::content(scratch / "fields/000001.h5"), first);
  EXPECT_THAT(test::content(scratch / "run.xdmf"), Not(HasSubstr("000002")));
  results.store(snapshot(2));
  EXPECT_THAT(results.steps(), ElementsAre(1, 2));
}

TEST(ResultsWriter, CannotStartWhereNothingCanBeWritten) {
  const Scratch scratch;
  test::put(scratch / "file.txt", "x");
  EXPECT_THROW(ResultsWriter(scratch / "file.txt", small_mesh(), {}), OutputError);
}

TEST(ResultsWriter, StepsStoredBeforeAKillStayReadable) {
  for (useconds_t pause = 3000; pause < 60000; pause += 1700) {
    const Scratch scratch;
    const int stored = test::kill_after(pause, [&](const auto& say) {
      ResultsWriter results(scratch.path(), small_mesh(), {});
      for (int step = 1;; ++step) {
        results.store(snapshot(step));
        say(step);
      }
    });
    if (stored == 0) continue;
    const ResultsWriter results = ResultsWriter::resume(scratch.path(), stored);
    ASSERT_EQ(results.steps().size(), static_cast<std::size_t>(stored)) << "killed after " << pause << " µs";
    EXPECT_EQ(field_files(scratch).size(), static_cast<std::size_t>(stored) + 1) << "a mesh and whole steps";
    for (const int step : results.steps())
      EXPECT_EQ(reading(scratch, step_file(step)).numbers("/stress").at(0), step);
  }
}

}  // namespace
}  // namespace dda
