#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "framework/files/whole_file.hpp"
#include "unit/framework/deck/messages.hpp"
#include "unit/studies/dda/sweep/sweep_example.hpp"

namespace dda {
namespace {

using test::SweepExample;
using testing::ElementsAre;
using testing::HasSubstr;

std::string refusal(const std::string& text) {
  const SweepExample example(text);
  return messages([&] { example.read(); });
}

TEST(Sweep, CasesAreTheProductAndSayWhatTheyOverride) {
  const SweepExample example("sweep: {deck: a.yaml, thickness: [1, 2], plane: [stress, strain]}\n");
  const Sweep sweep = example.read({"path.stop.steps=7"});
  ASSERT_EQ(sweep.cases.size(), 4u);
  EXPECT_THAT(sweep.cases[1].overrides, ElementsAre("path.stop.steps=7", "thickness=1", "plane=strain"));
  EXPECT_EQ(sweep.cases[1].deck, example.folder() / "a.yaml");
  EXPECT_THAT(sweep.cases[1].effective, HasSubstr("plane: strain"));
  EXPECT_THAT(sweep.cases[3].effective, HasSubstr("steps: 7"));
  EXPECT_THAT(sweep.key_units, ElementsAre("mm", ""));
  EXPECT_EQ(settings_text(sweep, sweep.cases[2]), "thickness=2, plane=stress");
}

TEST(Sweep, OfTheDeckItStandsIn) {
  const SweepExample example(test::small_deck("sweep: {thickness: [1, 2]}\n"));
  const Sweep sweep = example.read();
  EXPECT_EQ(sweep.title, "A small beam");
  EXPECT_EQ(sweep.cases[0].deck, example.folder() / "s.yaml");
  EXPECT_THAT(sweep.cases[0].overrides, ElementsAre("sweep=", "thickness=1"));
  EXPECT_TRUE(is_sweep(read_yaml(example.folder() / "s.yaml"), {}));
  EXPECT_FALSE(is_sweep(read_yaml(example.folder() / "s.yaml"), {"sweep="}));
  EXPECT_FALSE(is_sweep(read_yaml(example.folder() / "a.yaml"), {"thickness=1"}));
}

TEST(Sweep, OfSeveralDecks) {
  const Sweep sweep = SweepExample("title: Both\nsweep: {deck: [b.yaml, a.yaml], thickness: [1]}\n").read();
  ASSERT_EQ(sweep.cases.size(), 2u);
  EXPECT_EQ(sweep.title, "Both");
  EXPECT_EQ(sweep.units.length, "m");
  EXPECT_THAT(sweep.cases[1].overrides, ElementsAre("thickness=1"));
}

TEST(Sweep, SeedIsEverySeedOfTheEffectiveDeck) {
  const Sweep sweep = SweepExample("sweep: {deck: a.yaml, seed: 4..5}\n").read();
  EXPECT_THAT(sweep.cases[1].overrides, ElementsAre("scene.subdivision.seed=5"));
  EXPECT_THAT(sweep.cases[1].seeds, ElementsAre("scene.subdivision.seed"));
  EXPECT_THAT(refusal("sweep:\n  deck: a.yaml\n  seed: [1, x]\n"), HasSubstr("s.yaml:3:13: seed: expected"));
  EXPECT_THAT(refusal("sweep: {deck: a.yaml, seed: [1], scene.subdivision: [triangles]}\n"),
              HasSubstr("s.yaml:1:23: seed: "));
}

TEST(Sweep, DerivedColumnsAreOfKeysTheDeckAndTheSummary) {
  const Sweep sweep =
      SweepExample(
          "sweep:\n  deck: a.yaml\n  materials.stone.young_modulus: [100, 200]\n"
          "  columns: {slender: young_modulus/(2e0*thickness), half: \"max(peak.load/2, pi)\"}\n")
          .read();
  ASSERT_EQ(sweep.derived.size(), 2u);
  EXPECT_THAT(sweep.derived[0].names, ElementsAre("young_modulus", "thickness"));
  const Json summary{{"peak", {{"load", 10}}}};
  EXPECT_THAT(values_of(sweep.derived, sweep.cases[1].known, summary), ElementsAre(100, 5));
  EXPECT_THAT(values_of(sweep.derived, sweep.cases[1].known, Json()), ElementsAre(100, std::nullopt))
      << "no summary yet";
}

TEST(Sweep, DerivedColumnsAreOfVariablesAndOfColumnsBeforeThem) {
  SweepExample example(
      "sweep:\n  deck: b.yaml\n  variables.L: [1, 2]\n  columns: {area: thickness*L*h, double: 2*area}\n");
  write_whole(example.folder() / "b.yaml",
              "extends: a.yaml\nvariables: {L: 5, h: 3*L}\nthickness: L\nsupport_stiffness: h\n",
              Flush::to_system);
  const Sweep sweep = example.read();
  EXPECT_THAT(values_of(sweep.derived, sweep.cases[0].known, Json()), ElementsAre(3, 6));
  EXPECT_THAT(values_of(sweep.derived, sweep.cases[1].known, Json()), ElementsAre(24, 48));
}

TEST(Sweep, ColumnsOfTheTableAreNoNamesOfDerivedOnes) {
  const auto with = [](const std::string& name) {
    return refusal("sweep:\n  deck: a.yaml\n  thickness: [1, 2]\n  columns:\n    " + name + ": 2\n");
  };
  for (const std::string name : {"case", "folder", "status", "exit_code", "reason", "steps", "thickness"})
    EXPECT_THAT(with(name),
                HasSubstr("s.yaml:5:5: columns." + name + ": sweep.csv has a column of that name"));
}

TEST(Sweep, DerivedColumnsThatNobodyKnowsAreRefused) {
  const auto with = [](const std::string& column) {
    return refusal("sweep:\n  deck: a.yaml\n  thickness: [1, 2]\n  columns:\n    " + column + "\n");
  };
  EXPECT_THAT(with("a: peak.lod/2"), HasSubstr("s.yaml:5:5: columns.a: 'peak.lod' is no varied key"));
  EXPECT_THAT(with("a: peak.lod/2"), HasSubstr("did you mean 'peak.load'?"));
  EXPECT_THAT(with("a: 2*(thickness"), HasSubstr("s.yaml:5:8: columns.a: "));
  EXPECT_THAT(with("steps: thickness"), HasSubstr("columns.steps: sweep.csv has a column of that name"));
  EXPECT_THAT(with("b: a\n    a: thickness"), HasSubstr("columns.b: 'a' is no varied key"));
  EXPECT_THAT(with("a.b: thickness"), HasSubstr("columns.a.b: a name is of letters"));
  EXPECT_THAT(with("a: [1]"), HasSubstr("columns.a: expected an expression"));
  EXPECT_THAT(refusal("sweep: {deck: a.yaml, thickness: [1], columns: 3}\n"),
              HasSubstr("columns: expected a map"));
}

TEST(Sweep, CommandLineVariesKeys) {
  const SweepExample example("sweep: {deck: a.yaml, thickness: [1, 2]}\n");
  EXPECT_EQ(example.read({"sweep.thickness=1..5"}).cases.size(), 5u);
  EXPECT_EQ(example.read({"sweep.path.stop.steps=[3, 4]"}).cases.size(), 4u);
  EXPECT_EQ(read_sweep(example.folder() / "a.yaml", {"sweep.seed=1..3"}).cases.size(), 3u);
  EXPECT_THAT(messages([&] { example.read({"sweep.thicknes=[1]"}); }),
              HasSubstr("--set sweep.thicknes: unknown parameter 'thicknes'; did you mean 'thickness'?"));
}

TEST(Sweep, MistakesStandAtTheEntriesOnce) {
  const std::string said = refusal(
      "sweep:\n  deck: a.yaml\n  thicknes: [1, 2]\n  materials.stone.young_modulus: [1, -2]\n  seed: 1..9\n");
  EXPECT_THAT(said, HasSubstr("s.yaml:3:3: unknown parameter 'thicknes'"));
  EXPECT_THAT(said, HasSubstr("s.yaml:4:38: young_modulus: must be above 0"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1);
  EXPECT_THAT(refusal("sweep:\n  deck: a.yaml\n  title.x: [1]\n"),
              HasSubstr("s.yaml:3:3: the path goes through the value 'A small beam'"));
}

TEST(Sweep, RefusesDecksThatAreNone) {
  EXPECT_THAT(refusal("sweep: {deck: c.yaml, thickness: [1]}\n"),
              HasSubstr("s.yaml:1:15: deck: no such file 'c.yaml'"));
  EXPECT_THAT(refusal("sweep: {deck: [a.yaml, s.yaml]}\n"),
              HasSubstr("s.yaml:1:24: deck: 's.yaml' is a sweep itself"));
  EXPECT_THAT(refusal("sweep: {deck: [[a.yaml]]}\n"), HasSubstr("expected the name of a file"));
  EXPECT_THAT(refusal("plane: stress\nsweep: {deck: [a.yaml]}\n"),
              HasSubstr("s.yaml:1:1: 'plane' belongs to a deck"));
  EXPECT_THAT(refusal("title: none\n"), HasSubstr("has no section `sweep`"));
  EXPECT_THAT(refusal("deck: base.yaml\nsweep: {seed: [1, 2]}\n"),
              HasSubstr("stands in the section `sweep`"));
  EXPECT_THAT(refusal("sweep: 3\n"), HasSubstr("s.yaml:1:8: sweep: expected a map"));
}

}  // namespace
}  // namespace dda
