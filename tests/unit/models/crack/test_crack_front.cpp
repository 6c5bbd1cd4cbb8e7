#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "models/crack_front.hpp"
#include "support/cut_structure.hpp"

namespace dda {
namespace {

/// A structure with cracks that begin at some places.
struct Fronts {
  explicit Fronts(const std::string& subdivision, std::vector<CrackBegin> begin)
      : structure({.subdivision = subdivision}), deck(structure.deck()) {
    deck.cracks.front().begin = std::move(begin);
    deck.cracks.front().direction = crack_directions().choose("nonlocal_stress");
    front.emplace(structure.cracks(), structure.body(), deck);
    front->begin();
  }
  static CrackBegin at(double x, double y, const Vec2& direction) { return {Spot(x, y), direction}; }
  const std::vector<Cut>& cuts() { return structure.cracks().cuts(); }

  CutStructure structure;
  ModelDeck deck;
  std::optional<CrackFront> front;
};

/// Tension along an axis, everywhere.
CrackFront::Stress tension(double angle, double value = 0.01) {
  const double c = std::cos(angle), s = std::sin(angle);
  return [=](const Vec2&) { return Vec3(value * c * c, value * s * s, value * c * s); };
}

const std::string voronoi = "{type: voronoi, blocks: 120}", grid = "{type: grid, columns: 12, rows: 4}";

TEST(CrackFront, RunsStraightToTheBoundary) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  int segments = 1;
  for (; beam.front->grow(0); ++segments) {
    EXPECT_FALSE(beam.cuts().front().is_provisional);
    EXPECT_TRUE(beam.cuts().back().is_provisional);
  }
  EXPECT_EQ(beam.front->end_of(0), "the boundary");
  EXPECT_NEAR(beam.front->tip(0).y(), 10, 1e-12);
  EXPECT_NEAR(beam.front->tip(0).x(), 15.2, 1e-12);
  double length = 0;
  for (const Cut& cut : beam.cuts()) {
    EXPECT_FALSE(cut.is_provisional);
    length += cut.length();
  }
  EXPECT_NEAR(length, 10, 1e-12);
  EXPECT_LE(segments, static_cast<int>(10 / (0.5 * beam.structure.cracks().block_size())) + 1);
}

TEST(CrackFront, OpensTheSidesOfAGridThatItRunsAlong) {
  Fronts beam(grid, {Fronts::at(15, 0, {0.05, 1})});
  while (beam.front->grow(0)) {
  }
  EXPECT_EQ(beam.structure.cracks().num_jumps(), 0u);
  EXPECT_EQ(beam.cuts().size(), 4u);
  EXPECT_EQ(beam.front->tip(0), Vec2(15, 10));
}

TEST(CrackFront, IsAimedAcrossTheTensionWithTheInertiaOfWhatHasGrown) {
  for (const double turn : {-0.5, 0.2, 0.6}) {
    Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
    beam.front->grow(0);
    ASSERT_TRUE(beam.front->aim(0, tension(turn)));
    const Vec2 way = beam.cuts().back().end - beam.front->tip(0);
    // S = f n nᵀ + f/2 n₀ n₀ᵀ:  tan 2φ = sin 2ψ/(1/2 + cos 2ψ), ψ the turn of the tension
    const double wanted = 0.5 * std::atan2(std::sin(2 * turn), 0.5 + std::cos(2 * turn));
    EXPECT_NEAR(std::atan2(-way.x(), way.y()), wanted, 1e-9);
  }
}

TEST(CrackFront, StaysWhereTheAimIsTheSame) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  beam.front->grow(0);
  const auto before = beam.cuts().size();
  EXPECT_FALSE(beam.front->aim(0, tension(0.01)));
  EXPECT_FALSE(beam.front->aim(0, [](const Vec2&) { return std::optional<Vec3>(); }));
  EXPECT_EQ(beam.cuts().size(), before);
}

TEST(CrackFront, AimsASegmentThreeTimesAtMost) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  for (const double turn : {0.3, -0.3, 0.5}) EXPECT_TRUE(beam.front->aim(0, tension(turn)));
  EXPECT_FALSE(beam.front->aim(0, tension(-0.5)));
  beam.front->grow(0);
  EXPECT_TRUE(beam.front->aim(0, tension(-0.5)));
}

TEST(CrackFront, EndsOnAnotherCrack) {
  for (const std::string& pattern : {voronoi, grid}) {
    Fronts beam(pattern, {Fronts::at(15, 0, {0, 1}), Fronts::at(0, 5.3, {1, 0.01})});
    while (beam.front->grow(0)) {
    }
    while (beam.front->grow(1)) {
    }
    EXPECT_EQ(beam.front->end_of(0), "the boundary");
    EXPECT_EQ(beam.front->end_of(1), "another crack");
    EXPECT_NEAR(beam.front->tip(1).x(), 15, 1e-9) << "no piece is left between them";
    EXPECT_NEAR(beam.front->tip(1).y(), 5.45, 1e-9);
  }
}

TEST(CrackFront, ASegmentOnWhichAnotherCrackEndsStaysWhereItIs) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1}), Fronts::at(0, 0.4, {1, 0.001})});
  while (beam.front->grow(1)) {
  }
  ASSERT_EQ(beam.front->end_of(1), "another crack");
  EXPECT_FALSE(beam.front->aim(0, tension(0.5)));
  beam.front->grow(0);
  EXPECT_TRUE(beam.front->aim(0, tension(0.5)));
}

TEST(CrackFront, AimingOneCrackKeepsTheOthers) {
  Fronts beam(voronoi, {Fronts::at(8.2, 0, {0, 1}), Fronts::at(20.3, 0, {0, 1})});
  beam.front->grow(0);
  beam.front->grow(1);
  std::vector<Cut> of_other;
  for (const Cut& cut : beam.cuts())
    if (cut.crack == 1) of_other.push_back(cut);
  ASSERT_TRUE(beam.front->aim(0, tension(0.5)));
  std::vector<Cut> after;
  for (const Cut& cut : beam.cuts())
    if (cut.crack == 1) after.push_back(cut);
  ASSERT_EQ(after.size(), of_other.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_TRUE(after[i].is_at(of_other[i]));
    EXPECT_EQ(after[i].is_provisional, of_other[i].is_provisional);
  }
}

TEST(CrackFront, IsRestoredFromItsCutsAndMemory) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  beam.front->grow(0);
  beam.front->aim(0, tension(0.4));
  beam.front->grow(0);
  const std::vector<Cut> cuts = beam.cuts();
  Fronts other(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  other.front->restore(cuts, beam.front->memory());
  beam.front->aim(0, tension(-0.3));
  other.front->aim(0, tension(-0.3));
  ASSERT_EQ(other.cuts().size(), beam.cuts().size());
  for (std::size_t i = 0; i < beam.cuts().size(); ++i) {
    EXPECT_TRUE(other.cuts()[i].is_at(beam.cuts()[i]));
    EXPECT_EQ(other.cuts()[i].is_provisional, beam.cuts()[i].is_provisional);
  }
}

TEST(CrackFront, RefusesABeginOffTheOutlines) {
  EXPECT_THROW(Fronts(grid, {Fronts::at(15, 1, {0, -1}), Fronts::at(1.1, 1.2, {0, 1})}), InputError);
  EXPECT_THROW(Fronts(grid, {Fronts::at(15.2, 0, {0, -1})}), InputError) << "out of the body";
}

}  // namespace
}  // namespace dda
