#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "models/crack/front.hpp"
#include "support/cut_structure.hpp"

namespace dda {
namespace {

/// A structure with cracks that begin at some places.
struct Fronts {
  using Change = std::function<void(CrackParameters&)>;
  explicit Fronts(
      const std::string& subdivision, std::vector<CrackBegin> begin,
      const std::string& direction = "nonlocal_stress", const Change& change = [](CrackParameters&) {})
      : structure({.subdivision = subdivision}), deck(structure.deck()) {
    deck.cracks.front().begin = std::move(begin);
    deck.cracks.front().direction = crack_directions().choose(direction);
    change(deck.cracks.front());
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
CrackFront::Surroundings tension(double angle, double value = 0.01) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {[=](const Vec2&) { return Vec3(value * c * c, value * s * s, value * c * s); }, {}};
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
    // S = f n nᵀ + ι* f n₀ n₀ᵀ:  tan 2φ = sin 2ψ/(ι* + cos 2ψ), ψ the turn of the tension; ι* = ι l_ch/60h of small blocks
    const double zone = 2 * 0.01 / (0.01 * 0.01),
                 inertia = 0.5 * zone / 60 / beam.structure.cracks().block_size();
    ASSERT_GT(inertia, 0.5);
    const double wanted = 0.5 * std::atan2(std::sin(2 * turn), inertia + std::cos(2 * turn));
    EXPECT_NEAR(std::atan2(-way.x(), way.y()), wanted, 1e-9);
  }
}

TEST(CrackFront, HasNoInertiaBeforeItHasGrown) {
  for (const double turn : {-0.5, 0.2, 0.6})
    for (const double begun : {-0.3, 0.0, 0.3}) {
      Fronts beam(voronoi, {Fronts::at(15.2, 0, {begun, 1})});
      ASSERT_TRUE(beam.front->aim(0, tension(turn)));
      const Vec2 way = beam.cuts().back().end - beam.front->tip(0);
      EXPECT_NEAR(std::atan2(-way.x(), way.y()), turn, 1e-9);
    }
}

TEST(CrackFront, IsStuckWhereItTurnsBackTowardsItsBeginning) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  ASSERT_TRUE(beam.front->grow(0));
  bool goes_on = true;
  for (int n = 0; goes_on && n < 12; ++n) {
    const Vec2 way = (beam.cuts().back().end - beam.front->tip(0)).normalized();
    beam.front->aim(0, tension(std::atan2(-way.x(), way.y()) + 0.7, 1));
    goes_on = beam.front->grow(0);
  }
  EXPECT_FALSE(goes_on);
  EXPECT_EQ(beam.front->end_of(0), "it turns back towards its beginning");
  EXPECT_TRUE(beam.front->is_stuck(0));
}

TEST(CrackFront, StaysWhereTheAimIsTheSame) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  beam.front->grow(0);
  const auto before = beam.cuts().size();
  EXPECT_FALSE(beam.front->aim(0, tension(0.01)));
  EXPECT_FALSE(beam.front->aim(0, {[](const Vec2&) { return std::optional<Vec3>(); }, {}}));
  EXPECT_EQ(beam.cuts().size(), before);
}

TEST(CrackFront, AimsASegmentThreeTimesAtMost) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})});
  for (const double turn : {0.3, -0.3, 0.5}) EXPECT_TRUE(beam.front->aim(0, tension(turn)));
  EXPECT_FALSE(beam.front->aim(0, tension(-0.5)));
  beam.front->grow(0);
  EXPECT_TRUE(beam.front->aim(0, tension(-0.5)));
}

/// A millionth beside a corner, with the block behind it ahead: straight on next to nothing of a block would be cut off.
TEST(CrackFront, GoesOnFromACornerThatItHasAllButMet) {
  const std::string diagonal = "{type: grid, columns: 12, rows: 4}";
  Fronts beam(diagonal, {Fronts::at(15 - 1e-6, 0, {1, 1})});
  EXPECT_EQ(beam.cuts().front().start, Vec2(15, 0));
  EXPECT_EQ(beam.cuts().front().end, Vec2(17.5, 2.5));
  while (beam.front->grow(0)) {
  }
  EXPECT_EQ(beam.front->end_of(0), "the boundary");
  EXPECT_FALSE(beam.front->is_stuck(0));
  EXPECT_EQ(beam.front->tip(0), Vec2(25, 10));
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

/// The structure counts unknowns and points by it: next to a side of a grid the way wanted is the way that there is.
TEST(CrackFront, WhatIsAimedInVainKeepsTheOrderOfAllCuts) {
  Fronts beam(grid, {Fronts::at(7.5, 0, {0, 1}), Fronts::at(20, 0, {0, 1})});
  const std::vector<Cut> before = beam.cuts();
  EXPECT_FALSE(beam.front->aim(0, tension(0.05)));
  ASSERT_EQ(beam.cuts().size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_TRUE(beam.cuts()[i].is_at(before[i]));
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

/// A way that passes a corner of the grid by less than a thousandth of a block goes through it.
TEST(CrackFront, PassesThroughCornersThatItComesCloseTo) {
  Fronts beam(grid, {Fronts::at(11.25, 0, {1.25 + 1e-4, 2.5})});
  EXPECT_EQ(beam.cuts().front().end, Vec2(12.5, 2.5));
  Fronts other(grid, {Fronts::at(11.25, 0, {1.25 + 1e-2, 2.5})});
  EXPECT_NE(other.cuts().front().end, Vec2(12.5, 2.5));
}

/// The way is the top of a parabola of energies, whatever the lengths at which cuts end; a side that a trial way takes
/// turns it by a few degrees.
TEST(CrackFront, IsAimedWhereMostEnergyIsReleased) {
  for (const double top : {-0.4, 0.1, 0.7}) {
    Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})}, "released_energy");
    beam.front->grow(0);
    const CrackFront::Surroundings around{{}, [&](std::span<const Cut> free) {
                                            const Vec2 way = free.back().end - free.front().start;
                                            const double turn = std::atan2(-way.x(), way.y());
                                            return way.squaredNorm() * (2 - std::pow(turn - top, 2));
                                          }};
    ASSERT_TRUE(beam.front->aim(0, around));
    const Vec2 way = beam.cuts().back().end - beam.front->tip(0);
    EXPECT_NEAR(std::atan2(-way.x(), way.y()), top, 0.02);
  }
}

TEST(CrackFront, RunsStraightOnWhereNoWayReleasesMoreThanItsNeighbours) {
  Fronts beam(voronoi, {Fronts::at(15.2, 0, {0, 1})}, "released_energy");
  beam.front->grow(0);
  EXPECT_FALSE(beam.front->aim(0, {{}, [](std::span<const Cut> free) {
                                     const Vec2 way = free.back().end - free.front().start;
                                     return way.squaredNorm() * (2 + std::atan2(-way.x(), way.y()));
                                   }}));
}

/// A beam in two layers, `upper` above `lower`, that meet in a curve `joint`.
struct Layers {
  explicit Layers(std::vector<std::string> open, std::vector<std::string> end_at = {})
      : structure(
            "scene:\n  regions:\n"
            "    - {name: lower, material: stone, vertices: [[0, 0], [30, 0], [30, 5], [0, 5]]}\n"
            "    - {name: upper, material: brick, vertices: [[0, 5], [30, 5], [30, 10], [0, 10]]}\n"
            "  curves: {joint: [[0, 5], [30, 5]]}\n  subdivision: {type: voronoi, blocks: 120}\n"
            "thickness: 1\nmaterials:\n"
            "  stone: {type: linear_elastic, young_modulus: 2, poisson_ratio: 0.2}\n"
            "  brick: {type: linear_elastic, young_modulus: 3, poisson_ratio: 0.2}\n"
            "interfaces:\n"
            "  joint: {law: {type: linear_softening, tensile_strength: 0.1, fracture_energy: 0.1}}\n"
            "  stones: {between: [stone, stone], law: {type: linear_softening, tensile_strength: 0.01, "
            "fracture_energy: 0.01}}\n"
            "  bricks: {between: [brick, brick], law: {type: linear_softening, tensile_strength: 0.02, "
            "fracture_energy: 0.02}}\n"
            "supports: {left: {at: [0, 0], fix: xy}, right: {at: [30, 0], fix: y}}\n"
            "stages: [{loads: [{type: point_load, at: [15, 10], force: [0, -1]}]}]\n"),
        cracks(structure.assembly()),
        body(structure.body()),
        deck(structure.deck()) {
    body.cracks = &cracks;
    deck.cracks.push_back(cracks_through(std::move(open), 100));
    deck.cracks.front().begin = {{Spot(15.2, 0), {0.02, 1}}};
    deck.cracks.front().direction = crack_directions().choose("nonlocal_stress");
    deck.cracks.front().end_at = std::move(end_at);
    front.emplace(cracks, body, deck);
    front->begin();
    while (front->grow(0)) {
    }
  }

  Structure structure;
  CrackGeometry cracks;
  Body body;
  ModelDeck deck;
  std::optional<CrackFront> front;
};

TEST(CrackFront, StopsWhereNoCracksRunAndWhereItIsToldTo) {
  const Layers closed({"lower"}), told({"lower", "upper"}, {"joint"});
  EXPECT_EQ(closed.front->end_of(0), "region 'upper'");
  EXPECT_EQ(told.front->end_of(0), "interface 'joint'");
  for (const Layers* layers : {&closed, &told}) EXPECT_NEAR(layers->front->tip(0).y(), 5, 1e-12);
}

TEST(CrackFront, CrossesAnInterfaceWithTheLawOfTheRegionBeyond) {
  const Layers layers({"lower", "upper"});
  EXPECT_EQ(layers.front->end_of(0), "the boundary");
  const Equilibrium equilibrium(layers.body, layers.deck);
  int points = 0, of_joint = 0;
  for (const InterfacePoint& point : equilibrium.interfaces().points) {
    const double strength = point.stiffness * point.law->initial_kappa(point.stiffness);
    if (point.cut) {
      EXPECT_NEAR(strength, point.x.y() < 5 ? 0.01 : 0.02, 1e-12);
      ++points;
    }
    of_joint += point.law->can_crack() && !point.cut;
  }
  EXPECT_EQ(points, 2 * static_cast<int>(layers.cracks.cuts().size()));
  EXPECT_GT(of_joint, 0) << "may open beside the crack";
}

/// Bending of a beam, tension c (5 − y) (1 − (x − x0)²/1600) in x, into parts of the strength 0.01.
std::vector<Vec3> bent(const Assembly& assembly, double c, double x0) {
  std::vector<Vec3> out;
  for (const Block& block : assembly.blocks) {
    const Vec2& x = block.moments.centroid;
    out.emplace_back(0.01 * c * (5 - x.y()) * (1 - std::pow((x.x() - x0) / 40, 2)), 0, 0);
  }
  return out;
}

TEST(CrackFront, BeginsWhereStressAsksForIt) {
  Fronts beam(voronoi, {});
  const Assembly& assembly = beam.structure.assembly();
  const std::vector<Vec3> nothing(assembly.num_blocks(), Vec3::Zero());
  ASSERT_TRUE(beam.front->is_automatic());
  beam.front->begin_where_asked({BlockStress{nothing, bent(assembly, 1, 17)}});
  ASSERT_EQ(beam.front->num_cracks(), 1u);
  const double h = beam.structure.cracks().block_size();
  EXPECT_NEAR(beam.front->tip(0).x(), 17, h);
  EXPECT_NEAR(beam.front->tip(0).y(), 0, 1e-9);

  EXPECT_FALSE(beam.front->asked(bent(assembly, 0.17, 10))) << "0.85 of the strength";
  const auto moved = beam.front->asked(bent(assembly, 0.19, 10));
  ASSERT_TRUE(moved);
  EXPECT_EQ(moved->moved, 0);
  EXPECT_FALSE(beam.front->asked(bent(assembly, 0.19, 10), {0}))
      << "it stays where energy has been spent on it";
  EXPECT_EQ(beam.front->start(*moved), 0);
  EXPECT_NEAR(beam.front->tip(0).x(), 10, h);
  for (const Cut& cut : beam.cuts()) EXPECT_NEAR(cut.start.x(), 10, 2 * h) << "nothing stays where it was";
  beam.front->grow(0);
  EXPECT_FALSE(beam.front->asked(bent(assembly, 1, 20))) << "one crack, which has grown";
}

TEST(CrackFront, BeginsAsManyTimesAsItMayAndApart) {
  Fronts beam(voronoi, {}, "nonlocal_stress", [](CrackParameters& entry) {
    entry.most = 2;
    entry.apart = 6;
  });
  const Assembly& assembly = beam.structure.assembly();
  beam.front->begin_where_asked(
      {BlockStress{std::vector<Vec3>(assembly.num_blocks(), Vec3::Zero()), bent(assembly, 1, 17)}});
  beam.front->grow(0);
  const auto second = beam.front->asked(bent(assembly, 0.2, 17));
  ASSERT_TRUE(second);
  EXPECT_FALSE(second->moved);
  EXPECT_EQ(beam.front->start(*second), 1);
  EXPECT_GE(std::abs(beam.front->tip(1).x() - 17), 5);
  beam.front->grow(1);
  EXPECT_FALSE(beam.front->asked(bent(assembly, 0.2, 3))) << "no third one";
  EXPECT_TRUE(beam.front->may_have(beam.front->memory()));
}

TEST(CrackFront, BeginsNowhereWithoutTension) {
  Fronts beam(voronoi, {});
  const std::vector<Vec3> nothing(beam.structure.assembly().num_blocks(), Vec3::Zero());
  EXPECT_THROW(beam.front->begin_where_asked({BlockStress{nothing, nothing}}), InputError);
}

TEST(CrackFront, RefusesABeginOffTheOutlines) {
  EXPECT_THROW(Fronts(grid, {Fronts::at(15, 1, {0, -1}), Fronts::at(1.1, 1.2, {0, 1})}), InputError);
  EXPECT_THROW(Fronts(grid, {Fronts::at(15.2, 0, {0, -1})}), InputError) << "out of the body";
}

}  // namespace
}  // namespace dda
