#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "framework/base/errors.hpp"
#include "framework/files/curve_table.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda {
namespace {

using test::Scratch;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::vector<Column> columns = {{"step", ""}, {"load_factor", ""}, {"cmod", "mm"}, {"control", ""}};

std::vector<TableCell> row(std::int64_t step, double load, const std::string& control) {
  return {step, load, load / 3, control};
}

TEST(CurveTable, IsPlainCsvWithUnitsAside) {
  const Scratch scratch;
  CurveTable table(scratch / "curve.csv", columns);
  table.append(row(1, 0.75, "event"));
  EXPECT_EQ(test::content(scratch / "curve.csv"), "step,load_factor,cmod,control\n1,0.75,0.25,event\n");
  const auto units = nlohmann::json::parse(test::content(scratch / "curve.units.json"));
  EXPECT_EQ(units["cmod"], "mm");
}

TEST(CurveTable, NumbersReadBackExactly) {
  const Scratch scratch;
  const std::vector<double> values = {
      0.1, 1.0 / 3.0, 1e-300, -5e-324, 1.7976931348623157e308, 123456789012345680.0, -0.0};
  CurveTable table(scratch / "c.csv", {{"x", "mm"}});
  for (const double value : values) table.append(std::vector<TableCell>{value});
  const std::vector<double> read = read_csv(scratch / "c.csv").numbers("x");
  ASSERT_EQ(read.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(read[i], values[i]);
    EXPECT_EQ(std::signbit(read[i]), std::signbit(values[i]));
  }
}

TEST(CurveTable, NotANumberAndInfinityReadBack) {
  const Scratch scratch;
  CurveTable table(scratch / "c.csv", {{"x", ""}});
  table.append(std::vector<TableCell>{std::nan("")});
  table.append(std::vector<TableCell>{-std::numeric_limits<double>::infinity()});
  const std::vector<double> read = read_csv(scratch / "c.csv").numbers("x");
  EXPECT_TRUE(std::isnan(read.at(0)));
  EXPECT_EQ(read.at(1), -std::numeric_limits<double>::infinity());
}

TEST(CurveTable, TextsWithCommasQuotesAndLineBreaksReadBack) {
  const Scratch scratch;
  const std::vector<std::string> texts = {"a,b", "say \"yes\"", "two\nlines", "\"", "", "plain"};
  CurveTable table(scratch / "c.csv", {{"text, with comma", ""}, {"n", ""}});
  for (const std::string& text : texts) table.append(std::vector<TableCell>{text, std::int64_t{1}});
  EXPECT_EQ(read_csv(scratch / "c.csv").texts("text, with comma"), texts);
}

TEST(CurveTable, ResumesAfterARowAndDropsTheRest) {
  const Scratch scratch;
  {
    CurveTable table(scratch / "c.csv", columns);
    for (int i = 1; i <= 5; ++i) table.append(row(i, i, "line\nbreak"));
  }
  test::put(scratch / "c.csv", test::content(scratch / "c.csv") + "6,0.3");  // cut by a kill
  CurveTable table = CurveTable::resume(scratch / "c.csv", columns, 3);
  EXPECT_EQ(table.num_rows(), 3u);
  table.append(row(40, 4, "load"));
  EXPECT_THAT(read_csv(scratch / "c.csv").numbers("step"), ElementsAre(1, 2, 3, 40));
}

TEST(CurveTable, ResumeRefusesOtherColumnsAndMissingRows) {
  const Scratch scratch;
  CurveTable(scratch / "c.csv", columns).append(row(1, 1, "load"));
  EXPECT_THROW(CurveTable::resume(scratch / "c.csv", {{"step", ""}}, 1), InputError);
  EXPECT_THROW(CurveTable::resume(scratch / "c.csv", columns, 2), InputError);
}

TEST(CurveTable, FullDiskKeepsWholeRows) {
  const Scratch scratch;
  CurveTable table(scratch / "c.csv", columns);
  std::size_t stored = 0;
  {
    const test::FileSizeLimit limit(500);
    EXPECT_THROW(
        for (int i = 0; i < 1000; ++i) {
          table.append(row(i, i, "dissipation"));
          ++stored;
        },
        OutputError);
  }
  EXPECT_GT(stored, 0u);
  EXPECT_EQ(table.num_rows(), stored);
  EXPECT_EQ(read_csv(scratch / "c.csv").num_rows(), stored);
}

TEST(CurveTable, AKilledWriterLeavesItsRows) {
  const Scratch scratch;
  const auto write = [&](const auto& say) {
    CurveTable table(scratch / "c.csv", columns);
    for (int i = 1; i < 20000; ++i) {
      table.append(row(i, i, "load"));
      if (i < 8000) say(i);
    }
  };
  const int stored = test::kill_after(20000, write, test::From::first_piece);
  const CsvTable table = read_csv(scratch / "c.csv");
  EXPECT_GE(table.num_rows(), static_cast<std::size_t>(stored));
  EXPECT_GT(stored, 0);
}

TEST(CurveTable, WrongNumberOfCellsIsTheCallersMistake) {
  const Scratch scratch;
  CurveTable table(scratch / "c.csv", columns);
  EXPECT_THROW(table.append(std::vector<TableCell>{1.0}), std::invalid_argument);
}

TEST(ReadCsv, AMarkOfUtf8IsNoPartOfTheFirstName) {
  const Scratch scratch;
  test::put(scratch / "c.csv", "\xEF\xBB\xBFtime,x\n1,2\n");
  EXPECT_THAT(read_csv(scratch / "c.csv").numbers("time"), ElementsAre(1));
}

TEST(ReadCsv, NamesWhatIsWrong) {
  const Scratch scratch;
  test::put(scratch / "c.csv", "a,b\n1,2\n3\n");
  EXPECT_THAT(test::message_of<InputError>([&] { read_csv(scratch / "c.csv"); }), HasSubstr("c.csv:3"));
  test::put(scratch / "d.csv", "a,b\r\n1,x\r\n");
  const CsvTable table = read_csv(scratch / "d.csv");
  EXPECT_THAT(test::message_of<InputError>([&] { table.numbers("b"); }), HasSubstr("'x' is not a number"));
  EXPECT_THAT(test::message_of<InputError>([&] { table.numbers("c"); }), HasSubstr("the columns are a, b"));
  EXPECT_THAT(table.numbers("a"), ElementsAre(1));
}

}  // namespace
}  // namespace dda
