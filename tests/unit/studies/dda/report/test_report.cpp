#include <gmock/gmock.h>

#include <limits>

#include "framework/base/errors.hpp"
#include "framework/files/run/results_writer.hpp"
#include "studies/dda/report/report.hpp"
#include "unit/framework/files/scratch.hpp"

namespace dda::report {
namespace {

using test::message_of;
using test::put;
using test::Scratch;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* attack = "</script><script>alert('&amp;')</script><!-- \" \xE2\x80\xA8 -->";

TEST(Report, NoTextEndsTheElementThatHoldsTheData) {
  const Json data{{"title", attack}, {attack, "key"}};
  const std::string text = embedded(data);
  EXPECT_THAT(text, Not(HasSubstr("<")));
  EXPECT_THAT(text, Not(HasSubstr(">")));
  EXPECT_EQ(Json::parse(text), data);
}

TEST(Report, WhatIsNoUtf8IsReplaced) {
  const std::string text = embedded({{"title", "a\xFFz"}});
  EXPECT_EQ(Json::parse(text)["title"], "a\xEF\xBF\xBDz");
}

TEST(Report, NumbersThatJsonDoesNotKnowAreNull) {
  EXPECT_EQ(embedded({{"x", std::numeric_limits<double>::quiet_NaN()}}), "{\"x\":null}");
}

TEST(Report, TextBetweenTagsIsEscaped) {
  EXPECT_EQ(escaped("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

TEST(Report, ValuesAreNotSearchedForNames) {
  EXPECT_EQ(filled("@a@-@b@-@c@ x@y", {{"a", "@b@"}, {"b", "@a@"}}), "@b@-@a@-@c@ x@y");
}

TEST(Report, ThePageIsOneSelfContainedFile) {
  const std::string page = page_of({{"kind", "run"}, {"title", attack}});
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("alert('&amp;')</script>")));
  for (const char* outside : {" src=", "@import", "url(http", "fetch(", "<link"})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  for (const char* placeholder : {"@title@", "@styles@", "@scripts@", "@data@"})
    EXPECT_THAT(page, Not(HasSubstr(placeholder)));
  EXPECT_THAT(page, HasSubstr("class RunPage"));
  // The last script builds the page, when all the others are known.
  EXPECT_GT(page.find("\nbuild();"), page.find("class SweepPage"));
}

TEST(Report, FewStoredStepsAreAllShown) {
  for (const std::size_t peak : {0u, 1u, 2u, 9u})
    EXPECT_THAT(thinned(std::vector<std::size_t>{5, 5, 5}, 15, peak), ElementsAre(0, 1, 2));
}

TEST(Report, ManyStoredStepsAreThinnedEvenlyWithThePeak) {
  const std::vector<std::size_t> sizes(101, 10);
  EXPECT_THAT(thinned(sizes, 50, 1000), ElementsAre(0, 25, 50, 75, 100));
  EXPECT_THAT(thinned(sizes, 50, 43), ElementsAre(0, 25, 43, 75, 100));
  EXPECT_THAT(thinned(sizes, 50, 75), ElementsAre(0, 25, 50, 75, 100));
  EXPECT_THAT(thinned(sizes, 50, 0), ElementsAre(0, 25, 50, 75, 100));
  EXPECT_THAT(thinned(sizes, 10, 43), ElementsAre(100));
  EXPECT_THAT(thinned(sizes, 9, 43), IsEmpty());
  EXPECT_THAT(thinned(std::vector<std::size_t>{}, 9, 0), IsEmpty());
}

TEST(Report, RowsAreThinnedButNotTheWantedOnes) {
  EXPECT_THAT(kept_rows(4, 10, {2, 99}), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(kept_rows(100, 5, {7}), ElementsAre(0, 7, 20, 40, 60, 80, 99));
  EXPECT_THAT(kept_rows(0, 5, {}), IsEmpty());
}

TEST(Report, AColumnOfWordsStaysOne) {
  const CsvTable table("curve.csv", {"step", "control"}, {{"0", "1"}, {"start", "event"}});
  const Json columns = columns_of(table, {{"step", "s"}}, std::vector<std::size_t>{0, 1})["columns"];
  EXPECT_EQ(columns[0]["numbers"], "AAAAAAAAAAAAAAAAAADwPw==");  // 0.0 and 1.0 as doubles
  EXPECT_EQ(columns[0]["unit"], "s");
  EXPECT_EQ(columns[1]["texts"], Json({"start", "event"}));
}

TEST(Report, TheLogIsDigested) {
  const Scratch scratch;
  put(scratch / "log.jsonl",
      "{\"time\":\"t1\",\"level\":\"info\",\"event\":\"started\"}\n"
      "{\"time\":\"t2\",\"level\":\"info\",\"event\":\"step\",\"step\":1,\"residual\":0.5}\n"
      "{\"time\":\"t3\",\"level\":\"warning\",\"event\":\"notice\",\"text\":\"so\"}\n"
      "{\"time\":\"t4\",\"level\":\"info\",\"event\":\"step\",\"step\":1,\"residual\":0.25,\"landed\":"
      "\"cmod\"}\n"
      "{\"time\":\"t4\",\"event\":\"step\",\"step\":1,\"residual\":[1]}\n"
      "{\"time\":\"t5\",\"lev");
  const Json log = data_of_log(scratch / "log.jsonl", {});
  EXPECT_EQ(log["started"], "t1");
  EXPECT_EQ(log["last"], "t4");
  EXPECT_EQ(log["is_open"], true);
  EXPECT_EQ(log["events"].size(), 2u);
  EXPECT_EQ(log["steps"]["residual"], "AAAAAAAA0D8=");  // 0.25: the step as it was last taken
  EXPECT_EQ(log["steps"]["landed"]["1"], "cmod");
  const Json short_log = data_of_log(scratch / "log.jsonl", {.events = 1});
  EXPECT_EQ(short_log["left_out"], 1);
}

TEST(Report, ALongDeckIsCutAtALine) {
  const Scratch scratch;
  put(scratch / "deck.yaml", "title: x\nscene: 1\nmore: 2\n");
  EXPECT_EQ(read_text(scratch / "deck.yaml", 100), "title: x\nscene: 1\nmore: 2\n");
  EXPECT_EQ(read_text(scratch / "deck.yaml", 20),
            "title: x\nscene: 1\n# ... and 9 more characters, left out here\n");
  EXPECT_EQ(read_text(scratch / "none.yaml", 20), "");
}

/// Two triangles of which one turns and stretches, joined along a side that opens.
ResultsMesh two_triangles() {
  ResultsMesh mesh;
  mesh.blocks = {{{0, 0}, {1, 0}, {0, 1}}, {{1, 0}, {1, 1}, {0, 1}}};
  mesh.block_region = {0, 1};
  mesh.segments = {{Vec2{1, 0}, Vec2{0.5, 0.5}}, {Vec2{0.5, 0.5}, Vec2{0, 1}}};
  mesh.length_unit = "mm";
  return mesh;
}

Snapshot snapshot(int step) {
  const double x = step;
  return {
      step,
      x,
      {},
      {{"displacement", "mm", FieldPlace::block_vertex, 2, {0, 0, x, 0, 0, -x, 0, 0, 0, 0, 0, 0}, "x y z"},
       {"stress", "MPa", FieldPlace::block, 3, {x, 2, 3, 4, 5, 6}, "xx yy xy"},
       {"displacement", "mm", FieldPlace::segment_end, 2, {1, 2, 3, 4, 5, 6, 7, 8}, "x y z"},
       {"opening", "mm", FieldPlace::segment, 2, {0, 0, 3, -4}, "n s"},
       {"damage", "", FieldPlace::segment, 1, {0, 0.5}, ""}}};
}

TEST(Report, BlocksAndCracksAreCompact) {
  const Scratch scratch;
  ResultsWriter file(scratch.path(), two_triangles(), {});
  for (const int step : {1, 2, 3}) file.store(snapshot(step));
  const Json data = data_of_blocks(ResultsReader(scratch.path()), 2, {});
  EXPECT_EQ(data["stored"], 3);
  EXPECT_EQ(data["stress_unit"], "MPa");
  const Json& second = data["steps"][1];
  EXPECT_EQ(second["step"], 2);
  EXPECT_NEAR(second["motion"]["gradient"]["scale"], 2.0 / 32767, 1e-12);  // u_x = 2 x, u_y = -2 y
  EXPECT_NEAR(second["motion"]["mean"]["scale"], 2.0 / 3 / 32767, 1e-12);
  EXPECT_EQ(second["cracks"]["points"], "AQAAAA==");   // point 1 alone has damage
  EXPECT_EQ(second["cracks"]["opening"], "AABAQA==");  // 3, of w = (3, -4)
  EXPECT_EQ(second["cracks"]["sliding"], "AACAQA==");  // 4
}

/// Of a cut block the parts and their motion stand beside the blocks, and the cracked pieces behind the points of sides.
TEST(Report, PartsOfCutBlocksBelongToTheirStep) {
  const Scratch scratch;
  ResultsWriter file(scratch.path(), two_triangles(), {});
  file.store(snapshot(1));
  Snapshot cut = snapshot(2);
  cut.cut = {.parts = {{{1, 0}, {1, 1}, {0.5, 0.5}}, {{1, 1}, {0, 1}, {0.5, 0.5}}},
             .part_block = {1, 1},
             .pieces = {{Vec2{0.5, 0.5}, Vec2{0.75, 0.75}}, {Vec2{0.75, 0.75}, Vec2{1, 1}}}};
  cut.fields.push_back(
      {"displacement", "mm", FieldPlace::part_vertex, 2, {0, 0, 0, 0, 0, 0, 3, 0, 3, 0, 3, 0}, "x y z"});
  cut.fields.push_back({"displacement", "mm", FieldPlace::crack_end, 2, {0, 0, 0, 0, 1, 1, 2, 2}, "x y z"});
  cut.fields.push_back({"opening", "mm", FieldPlace::crack, 2, {0, 0, 2, -1}, "n s"});
  cut.fields.push_back({"damage", "", FieldPlace::crack, 1, {0, 1}, ""});
  file.store(cut);
  const Json steps = data_of_blocks(ResultsReader(scratch.path()), 2, {})["steps"];
  EXPECT_FALSE(steps[0].contains("parts"));
  const Json& parts = steps[1]["parts"];
  EXPECT_EQ(parts["blocks"], "AQAAAAEAAAA=");  // 1, 1
  EXPECT_EQ(parts["counts"], "AwADAA==");      // 3, 3
  EXPECT_NEAR(parts["motion"]["mean"]["scale"], 3.0 / 32767, 1e-12);
  const Json& cracks = steps[1]["cracks"];
  EXPECT_EQ(cracks["points"], "AQAAAA==");
  EXPECT_EQ(cracks["pieces"], "AABAPwAAQD8AAIA/AACAPw==");  // 0.75, 0.75, 1, 1
  EXPECT_EQ(cracks["opening"], "AABAQAAAAEA=");             // 3, then 2
  EXPECT_NEAR(cracks["ends"]["scale"], 8.0 / 32767, 1e-12);
}

TEST(Report, WhatDoesNotMoveHasNoSize) {
  const Scratch scratch;
  ResultsWriter file(scratch.path(), two_triangles(), {});
  file.store(snapshot(0));
  const Json data = data_of_blocks(ResultsReader(scratch.path()), 0, {});
  EXPECT_EQ(data["steps"][0]["motion"]["mean"]["scale"], 0.0);
  EXPECT_EQ(data["steps"][0]["motion"]["mean"]["integers"], "AAAAAAAAAAA=");  // four zeros of two bytes
}

TEST(Report, APageThatWouldBeTooLargeHasFewerSteps) {
  const Scratch scratch;
  ResultsWriter file(scratch.path(), two_triangles(), {});
  for (int step = 1; step <= 9; ++step) file.store(snapshot(step));
  const Json data = data_of_blocks(ResultsReader(scratch.path()), 2, {.fields = 2800});
  EXPECT_EQ(data["stored"], 9);
  ASSERT_EQ(data["steps"].size(), 3u);
  EXPECT_EQ(data["steps"][1]["step"], 2);
  EXPECT_EQ(data_of_blocks(ResultsReader(scratch.path()), 2, {.fields = 100})["steps"].size(), 0u);
}

TEST(Report, ARunWithoutFieldsHasNotices) {
  const Scratch scratch;
  put(scratch / "curve.csv", "step,control,load\n0,start,0\n1,event,5\n");
  put(scratch / "summary.json", "{ broken");
  const Json data = data_of_run(scratch.path(), {});
  EXPECT_EQ(data["curve"]["rows"], 2);
  EXPECT_TRUE(data["summary"].is_null());
  EXPECT_EQ(data["notices"].size(), 3u) << data["notices"];  // summary.json, fields/mesh.h5, log.jsonl
}

TEST(Report, LinksOfASweepStartAtThePage) {
  const Scratch scratch;
  std::filesystem::create_directories(scratch / "sweep" / "cases/001 a");
  std::filesystem::create_directories(scratch / "pages");
  put(scratch / "sweep" / "sweep.json",
      R"({"name": "s", "title": "Sizes", "cases": [{"number": 1, "folder": "cases/001 a", "status": "failed"}]})");
  const Json inside = data_of_sweep(scratch / "sweep", scratch / "sweep" / "report.html", {});
  EXPECT_EQ(inside["title"], "Sizes");
  EXPECT_EQ(inside["cases"][0]["link"], "./cases/001%20a/");
  const Json outside = data_of_sweep(scratch / "sweep", scratch / "pages" / "sizes.html", {});
  EXPECT_EQ(outside["cases"][0]["link"], "./../sweep/cases/001%20a/");
}

}  // namespace
}  // namespace dda::report
