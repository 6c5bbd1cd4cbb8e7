#include <gmock/gmock.h>

#include <Eigen/LU>

#include "support/structure.hpp"

namespace dda {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& yaml) {
  try {
    Structure(yaml).equilibrium();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string held_by(const std::string& support) {
  std::string deck = square_deck();
  const std::string wall = "wall: {boundary: left, fix: xy}";
  return deck.replace(deck.find(wall), wall.size(), support);
}

TEST(Support, FreeRigidMotionsAreNamed) {
  EXPECT_THAT(refusal(held_by("wall: {boundary: left, fix: x}")), HasSubstr("against: translation in y"));
  EXPECT_THAT(refusal(held_by("pin: {at: [0, 0], fix: xy}")), HasSubstr("against: rotation about ("));
  EXPECT_THAT(refusal(held_by("turn: {at: [0.2, 0.2], fix: rotation}")),
              testing::AllOf(HasSubstr("translation in x"), HasSubstr("translation in y"),
                             Not(HasSubstr("rotation"))));
  EXPECT_EQ(refusal(square_deck()), "");
}

TEST(Support, PlacesOffTheStructureAreRefused) {
  EXPECT_THAT(refusal(held_by("pin: {at: [2, 0], fix: xy}")), HasSubstr("lies outside every block"));
  EXPECT_THAT(refusal(held_by("wall: {boundary: lft, fix: xy}")), HasSubstr("unknown boundary 'lft'"));
}

TEST(Support, OverAPatchHoldsItsMeanAndReportsOneReaction) {
  const Structure square(
      held_by("wall: {over: [[0, 0.2], [0, 0.9]], fix: xy}\n  turn: {over: [[0, 0], [0, 1]], fix: "
              "rotation}\n  push: {over: [[0, 0], [0, 1]], fix: normal}"));
  const Equilibrium equilibrium = square.equilibrium();
  const double stiffness = 1e5 * 3 * 0.7;
  Mat2 turn;
  turn << 0, -0.3, 0.3, 0;
  // About (0, 0.55): the middle of the patch moves by (1, 2), that of the side by (1 + 0.3 · 0.05, 2).
  const std::vector<double> d = square.field(Vec2(1, 2) - turn * Vec2(0, 0.55), turn);
  const auto& reactions = equilibrium.stages().back().reactions;
  EXPECT_NEAR(reactions.at("wall.x").value(d, 0) / stiffness, -1, 1e-13);
  EXPECT_NEAR(reactions.at("wall.y").value(d, 0) / stiffness, -2, 1e-13);
  EXPECT_NEAR(reactions.at("turn").value(d, 0) / stiffness, -0.3 / 12, 1e-13);
  EXPECT_NEAR(reactions.at("push").value(d, 0) / stiffness, 1.015, 1e-13);
}

TEST(Support, OverAPatchAloneMayTurn) {
  EXPECT_THAT(refusal(held_by("wall: {over: [[0, 0.2], [0, 0.8]], fix: xy}")),
              HasSubstr("against: rotation about (0, 0.5)"));
  EXPECT_THAT(refusal(held_by("wall: {over: [[0, 0.2], [0, 0.8]], at: [0, 0], fix: xy}")),
              HasSubstr("a support needs one of `at`, `over` and `boundary`"));
}

TEST(Place, BlocksThatMeetShareOrOneIsMeant) {
  const Structure square(square_deck());
  EXPECT_EQ(blocks_of(square.assembly(), {Spot(0.6, 0.45), {}, {}}, {}).size(), 4u);
  EXPECT_EQ(blocks_of(square.assembly(), {Spot(0.6, 0.45), Spot(0.9, 0.1), {}}, {}),
            (std::vector{BlockId{1}}));
  EXPECT_THROW(blocks_of(square.assembly(), {Spot(0.1, 0.1), Spot(0.9, 0.1), {}}, {}), InputError);
}

TEST(Place, BoundaryPointsCarryTheLengthAndTheNormal) {
  const Structure square(square_deck());
  double length = 0;
  for (const BoundaryPoint& point : boundary_points(square.body(), "right", {})) {
    EXPECT_LT((point.normal - Vec2(1, 0)).norm(), 1e-14);
    EXPECT_NEAR(point.x.x(), 1, 1e-14);
    length += point.length;
  }
  EXPECT_NEAR(length, 1, 1e-14);
}

std::string joint(const std::string& energy) {
  return "  joint: {between: [mortar, stone], law: {type: linear_softening, tensile_strength: 0.01, "
         "fracture_energy: " +
         energy + "}}\n";
}

/// The steepest slope ft²/(2 Gf) decides: small keeps the treatment's k, steep raises it, too steep is
/// refused.
TEST(InterfacePoints, StiffnessFollowsTheSofteningSlope) {
  const Equilibrium mild = Structure(square_deck("", joint("2e-4"))).equilibrium();
  EXPECT_TRUE(mild.interfaces().notices.empty());
  const Equilibrium steep = Structure(square_deck("", joint("2e-6"))).equilibrium();
  ASSERT_EQ(steep.interfaces().notices.size(), 1u);
  EXPECT_THAT(steep.interfaces().notices[0], HasSubstr("stiffness raised"));
  for (std::size_t p = 0; p < steep.num_active(); ++p) {
    EXPECT_GE(steep.point(p).stiffness, mild.point(p).stiffness);
    EXPECT_GE(steep.point(p).stiffness, 1.02 * steep.point(p).law->steepest_slope());
  }
  EXPECT_THAT(refusal(square_deck("", joint("5e-7"))), HasSubstr("blocks are too large for the softening"));
}

const std::string uniform = R"(stages:
  - {name: shrink, loads: [{type: initial_stress, xx: 0.3, yy: -0.2, xy: 0.1}]}
  - {name: more, loads: [{type: initial_stress, xx: 0.1}, {type: point_load, at: [1, 1], force: [0, 1]}]}
support_stiffness: 1e-13
)";

/// In one material without supports the strain −C⁻¹σ0 leaves no stress: every joint and block is at rest.
TEST(Loading, InitialStressIsInEquilibriumWithConsistentJoints) {
  std::string deck = square_deck(uniform);
  deck.replace(deck.find("young_modulus: 3, poisson_ratio: 0.3"), 36, "young_modulus: 2, poisson_ratio: 0.2");
  const Structure square(deck);
  const Equilibrium equilibrium = square.equilibrium();
  const Loading& loading = equilibrium.stages()[0];
  const Vec3 strain = -square.body().materials[0]->stiffness().inverse() * Vec3(0.3, -0.2, 0.1);
  Mat2 g;
  g << strain.x(), strain.z() / 2, strain.z() / 2, strain.y();
  const std::vector<double> d = square.field({0, 0}, g);
  std::vector<double> q(2 * equilibrium.num_active()), residual(d.size(), 0.0);
  equilibrium.gather(loading, d, 1, q);
  for (const double opening : q) EXPECT_NEAR(opening, 0, 1e-14);
  equilibrium.intact().multiply_add(d, residual);
  std::vector<double> trial = loading.reference_offset;
  for (std::size_t i = 0; i < trial.size(); ++i)
    trial[i] *= equilibrium.point(i / 2).trial_stiffness()[static_cast<Eigen::Index>(i % 2)];
  equilibrium.scatter_add(trial, residual);
  for (std::size_t i = 0; i < d.size(); ++i) EXPECT_NEAR(residual[i], loading.reference[i], 1e-12);
}

TEST(Loading, AStageIsDeadInTheNext) {
  const Structure square(square_deck(uniform));
  const Equilibrium equilibrium = square.equilibrium();
  ASSERT_EQ(equilibrium.stages().size(), 2u);
  const Loading &first = equilibrium.stages()[0], &second = equilibrium.stages()[1];
  EXPECT_EQ(second.dead, first.reference);
  EXPECT_EQ(second.dead_offset, first.reference_offset);
  for (const double f : first.dead) EXPECT_EQ(f, 0);
  EXPECT_NE(second.reference, first.reference);
  EXPECT_EQ(second.load.value(std::vector<double>(24, 0.0), 0.5), 0.5) << "resultant 1 times the load factor";
}

const std::string one_after_another = R"(stages:
  - {name: dead, loads: [{type: point_load, at: [1, 1], force: [0.5, 0]}]}
  - {name: shrink, loads: [{type: initial_stress, xx: 0.3, yy: -0.2, xy: 0.1}], until: {load_factor: 1}}
  - {name: back, unload: true, until: {load_factor: 0}}
  - {name: drive, loads: [{type: prescribed_displacement, at: [1, 1], direction: [0, 1], displacement: 0.1}], until: {load: 1}}
  - {name: push, loads: [{type: point_load, at: [1, 1], force: [0, 1]}]}
support_stiffness: 1e-13
)";

TEST(Loading, AHeldStageIsDeadAtItsLoadFactor) {
  const Structure square(square_deck(one_after_another));
  Equilibrium equilibrium = square.equilibrium();
  EXPECT_EQ(square.deck().num_dead_stages(), 1u);
  EXPECT_EQ(square.deck().followed_stages(), (std::vector<std::size_t>{1, 3, 4}));
  EXPECT_EQ(square.deck().legs().size(), 4u);
  ASSERT_EQ(equilibrium.stages().size(), 2u);
  ASSERT_EQ(equilibrium.later_stages().size(), 2u);
  const Loading* followed = &equilibrium.stages().back();
  const Loading first = *followed;
  EXPECT_EQ(first.name, "shrink");
  equilibrium.hold(square.body(), square.deck(), 0.25);
  ASSERT_EQ(&equilibrium.stages().back(), followed) << "in the same place";
  const Loading second = *followed;
  EXPECT_EQ(second.name, "drive");
  for (std::size_t i = 0; i < first.dead.size(); ++i)
    EXPECT_DOUBLE_EQ(second.dead[i], first.dead[i] + 0.25 * first.reference[i]);
  for (std::size_t i = 0; i < first.reference_offset.size(); ++i)
    EXPECT_DOUBLE_EQ(second.dead_offset[i], 0.25 * first.reference_offset[i]);
  EXPECT_TRUE(second.initial_stress(0, 1).isApprox(0.25 * first.initial_stress(0, 1), 1e-15));
  equilibrium.hold(square.body(), square.deck(), -2);
  EXPECT_EQ(followed->name, "push");
  EXPECT_TRUE(equilibrium.later_stages().empty());
  ASSERT_EQ(followed->driven.size(), 1u);
  const double stiffness = equilibrium.driven_springs().front().stiffness;
  EXPECT_DOUBLE_EQ(followed->driven.front().force.constant, -2 * 0.1 * stiffness) << "its far end stays";
  EXPECT_EQ(followed->driven.front().force.per_load_factor, 0);
}

TEST(Loading, HeldStagesAreThoseOfAnEquilibriumMadeWithThem) {
  const Structure square(square_deck(one_after_another));
  Equilibrium held = square.equilibrium();
  held.hold(square.body(), square.deck(), 0.3);
  held.remake(square.body(), square.deck());
  const Equilibrium made(square.body(), square.deck(), {.held_load_factors = {0.3}, .rest = {}, .borne = {}});
  EXPECT_EQ(held.held_load_factors(), made.held_load_factors());
  EXPECT_EQ(held.stages().back().name, made.stages().back().name);
  EXPECT_EQ(held.stages().back().dead, made.stages().back().dead);
  EXPECT_EQ(held.stages().back().reference, made.stages().back().reference);
}

std::vector<double> residual(const Equilibrium& equilibrium, const std::vector<double>& d,
                             double load_factor) {
  const Loading& loading = equilibrium.stages().back();
  std::vector<double> out(d.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = -loading.dead[i] - load_factor * loading.reference[i];
  equilibrium.intact().multiply_add(d, out);
  return out;
}

TEST(Support, ForcesStandForWhatAStageChanges) {
  std::string deck = square_deck(R"(stages:
  - {name: dead, loads: [{type: point_load, at: [1, 1], force: [0.5, 0]}]}
  - name: struck
    loads: [{type: support_removal, support: prop}]
    until: {load_factor: 1}
  - {name: push, loads: [{type: point_load, at: [1, 1], force: [0, 1]}]}
support_stiffness: 1
)");
  const std::string wall = "wall: {boundary: left, fix: xy}";
  deck.replace(deck.find(wall), wall.size(),
               wall + "\n  prop: {at: [1, 0], fix: y}\n  tie: {at: [1, 1], fix: x, from: struck}");
  const Structure square(deck);
  Equilibrium equilibrium = square.equilibrium();
  EXPECT_EQ(equilibrium.springs_to_add().size(), 1u);
  EXPECT_EQ(equilibrium.springs_to_remove().size(), 1u);
  Mat2 g;
  g << 0.1, 0.2, -0.3, 0.4;
  const std::vector<double> d = square.field({0.3, -0.2}, g);
  const std::vector<double> before = residual(equilibrium, d, 0);
  const SupportChange change = equilibrium.support_change(d);
  equilibrium.change_supports(square.body(), square.deck(), change);
  EXPECT_TRUE(equilibrium.springs_to_add().empty());
  EXPECT_TRUE(equilibrium.springs_to_remove().empty());
  const std::vector<double> after = residual(equilibrium, d, 0), gone = residual(equilibrium, d, 1);
  double missing = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    EXPECT_NEAR(after[i], before[i], 1e-12);
    if (i % block_unknowns == 1) missing += gone[i] - before[i];
  }
  const Vec2 corner(0.3 + 0.1, -0.2 - 0.3);  // u of (1, 0), where the prop stood
  constexpr double stiffness = 3 * 0.7;
  EXPECT_NEAR(change.borne.front(), -stiffness * corner.y(), 1e-12);
  EXPECT_NEAR(missing, change.borne.front(), 1e-12) << "of the vertical forces on the blocks";
  const auto& reactions = equilibrium.stages().back().reactions;
  EXPECT_NEAR(reactions.at("prop").value(d, 0.25), 0.75 * change.borne.front(), 1e-12);
  EXPECT_NEAR(reactions.at("tie").value(d, 0), 0, 1e-12);
}

}  // namespace
}  // namespace dda
