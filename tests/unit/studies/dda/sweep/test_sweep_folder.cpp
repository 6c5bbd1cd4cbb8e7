#include <gmock/gmock.h>

#include "studies/dda/sweep/case_command.hpp"
#include "studies/dda/sweep/sweep_files.hpp"
#include "studies/dda/sweep/sweep_folder.hpp"
#include "unit/framework/deck/messages.hpp"
#include "unit/studies/dda/sweep/sweep_example.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using test::put;
using test::SweepExample;
using testing::ElementsAre;
using testing::HasSubstr;

/// A run folder as the program leaves it, of a deck and with a summary.
void make_run(const fs::path& folder, const SweepCase& one, const std::string& summary = "") {
  fs::create_directories(folder);
  put(folder / "effective_deck.yaml", "# a comment\n" + one.effective);
  if (!summary.empty()) put(folder / "summary.json", summary);
}

class SweepFolder : public testing::Test {
 protected:
  SweepExample example_{"sweep: {deck: a.yaml, thickness: [1, 2, 3]}\n"};
  Sweep sweep_ = example_.read();
  fs::path folder_ = example_.folder() / "runs";
  fs::path cases_ = folder_ / "cases";
};

TEST_F(SweepFolder, NumbersHaveRoomForAll) {
  EXPECT_EQ(case_folder(sweep_, 1), "cases/002");
  sweep_.cases.resize(1000);
  EXPECT_EQ(case_folder(sweep_, 1), "cases/0002");
}

TEST_F(SweepFolder, StateIsWhatARunLeft) {
  make_run(cases_ / "001", sweep_.cases[0]);
  EXPECT_EQ(state_of(cases_ / "001").status, CaseStatus::pending);
  EXPECT_FALSE(state_of(cases_ / "001").can_resume);
  put(cases_ / "001" / "restart.h5", "");
  EXPECT_TRUE(state_of(cases_ / "001").can_resume);
  put(cases_ / "001" / "summary.json", R"({"status": "interrupted"})");
  EXPECT_EQ(state_of(cases_ / "001").status, CaseStatus::interrupted);
  EXPECT_TRUE(state_of(cases_ / "001").can_resume);
  put(cases_ / "001" / "summary.json", R"({"status": "stopped_early", "reason": "tired"})");
  const CaseState stopped = state_of(cases_ / "001");
  EXPECT_TRUE(stopped.has_result());
  EXPECT_FALSE(stopped.can_resume);
  EXPECT_EQ(stopped.exit_code, 3);
  EXPECT_EQ(stopped.reason, "tired");
  put(cases_ / "001" / "summary.json", R"({"status": "goal_rea)");
  EXPECT_EQ(state_of(cases_ / "001").status, CaseStatus::pending);
}

TEST_F(SweepFolder, RunsAreKnownByWhatTheyComputeAndMoved) {
  make_run(cases_ / "001", sweep_.cases[2]);
  make_run(cases_ / "003", sweep_.cases[0]);
  const Earlier earlier = examine(folder_, sweep_);
  EXPECT_THAT(earlier.kept, ElementsAre(cases_ / "003", "", cases_ / "001"));
  EXPECT_TRUE(earlier.others.empty());
  EXPECT_EQ(earlier.num_kept(), 2u);
  place_cases(folder_, sweep_, earlier, false);
  EXPECT_THAT(examine(folder_, sweep_).kept, ElementsAre(cases_ / "001", "", cases_ / "003"));
}

TEST_F(SweepFolder, EqualCasesKeepTheirPlaces) {
  const Sweep twice = SweepExample("sweep: {deck: a.yaml, thickness: [1, 1]}\n").read();
  make_run(cases_ / "002", twice.cases[1]);
  EXPECT_THAT(examine(folder_, twice).kept, ElementsAre("", cases_ / "002"));
  make_run(cases_ / "001", twice.cases[0]);
  EXPECT_THAT(examine(folder_, twice).kept, ElementsAre(cases_ / "001", cases_ / "002"));
}

TEST_F(SweepFolder, NothingIsLostUnasked) {
  SweepCase other = sweep_.cases[0];
  other.effective += "more: 1\n";
  make_run(cases_ / "002", other);
  const Earlier earlier = examine(folder_, sweep_);
  EXPECT_THAT(earlier.others, ElementsAre(cases_ / "002"));
  EXPECT_THAT(messages([&] { refuse_loss(folder_, sweep_, earlier); }),
              HasSubstr("1 of its runs is no longer in"));
  put(folder_ / "sweep.json", "{}");
  place_cases(folder_, sweep_, earlier, true);
  EXPECT_TRUE(fs::is_empty(cases_));
  fs::create_directories(example_.folder() / "else");
  put(example_.folder() / "else/file", "x");
  EXPECT_THAT(messages([&] { refuse_loss(example_.folder() / "else", sweep_, Earlier{}); }),
              HasSubstr("holds no sweep"));
}

TEST_F(SweepFolder, TableHasEveryNumberAndBlanks) {
  std::vector<CaseState> states(3);
  states[0].status = CaseStatus::goal_reached;
  states[0].exit_code = 0;
  states[0].summary = Json::parse(
      R"({"status": "goal_reached", "reason": "done, well", "peak": {"load": 2.5, "gauges": {"v": 1}}, "steps": 3, "list": [1], "bad": null})");
  states[0].curve_units = Json::parse(R"({"load": "N", "v": "mm"})");
  states[2].status = CaseStatus::failed;
  states[2].exit_code = 4;
  states[2].reason = "said \"no\"";
  const SweepTable table = sweep_table(sweep_, states);
  EXPECT_EQ(table.csv,
            "case,folder,thickness,status,exit_code,reason,peak.load,peak.gauges.v,steps,bad\n"
            "1,cases/001,1,goal_reached,0,,2.5,1,3,\n"
            "2,cases/002,2,pending,,,,,,\n"
            "3,cases/003,3,failed,4,\"said \"\"no\"\"\",,,,\n");
  EXPECT_EQ(table.units["peak.load"], "N");
  EXPECT_EQ(table.units["peak.gauges.v"], "mm");
  EXPECT_EQ(table.units["thickness"], "mm");
  EXPECT_EQ(table.units["status"], "");
  const Json json = sweep_json(sweep_, "name", states);
  EXPECT_EQ(json["cases"][2]["settings"]["thickness"], 3);
  EXPECT_EQ(json["cases"][2]["exit_code"], 4);
  EXPECT_TRUE(json["cases"][1]["exit_code"].is_null());
  EXPECT_EQ(json["axes"][0]["values"]["thickness"].size(), 3u);
}

TEST(CaseCommand, RunsACaseOrTheRestOfIt) {
  const SweepExample example("sweep: {deck: a.yaml, thickness: [1, 2]}\n");
  const Sweep sweep = example.read({"path.stop.steps=7"});
  const std::string deck = sweep.cases[1].deck.string();
  EXPECT_THAT(case_command(sweep, "out", 1, false),
              ElementsAre("run", deck, "--folder", "out/cases/002", "--quiet", "--overwrite", "--set",
                          "path.stop.steps=7", "--set", "thickness=2"));
  EXPECT_THAT(case_command(sweep, "out", 1, true), ElementsAre("resume", "out/cases/002", "--quiet"));
}

TEST(LineOfCases, IsTheSweepItselfCaseByCase) {
  const SweepExample example("sweep: {deck: a.yaml, thickness: [1, 2, 3]}\n");
  const std::string line = line_of_cases(example.read({"title=it's {} here"}), "my runs", 2);
  EXPECT_THAT(line, testing::StartsWith("seq 3 | OMP_NUM_THREADS="));
  EXPECT_THAT(line, HasSubstr(" xargs -P 2 -n 1 "));
  EXPECT_THAT(line, testing::EndsWith(" --quiet --folder 'my runs' --set 'title=it'\\''s {} here' --case"));
}

}  // namespace
}  // namespace dda
