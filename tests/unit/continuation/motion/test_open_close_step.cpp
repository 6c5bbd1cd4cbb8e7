// Steps whose contacts open and close, against closed forms.
#include <gmock/gmock.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "continuation/bodies/entrances.hpp"
#include "continuation/motion/step/open_close_step.hpp"
#include "unit/continuation/motion/blocks.hpp"

namespace dda {
namespace {

using State = OpenCloseContact::State;

std::shared_ptr<const Integrator> classic(const std::string& parameters = "") {
  return integrator("{type: classic" + (parameters.empty() ? "" : ", " + parameters) + "}");
}

MovingScene on_ground(const Polygon& outline, double friction, const Vec2& pull) {
  return scene(friction, {body(box(-5, -1, 9, 0), true), body(outline)}, pull);
}

TEST(Classic, FallsFreelyAtAnyStep) {
  for (const double step : {0.001, 0.01}) {
    const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, -gravity});
    Poses velocities = at_rest(of);
    velocities[0][0] = 2;
    Motion motion(of, {}, undeformed(of), velocities, {.time = 1, .step = step, .integrator = classic()});
    run(motion);
    EXPECT_NEAR(motion.poses()[0][0], 2.5, 1e-9);
    EXPECT_NEAR(motion.poses()[0][1], 0.5 - gravity / 2, 1e-9);
    EXPECT_NEAR(motion.ledger().kinetic / (motion.ledger().external + density * 2), 1, 1e-9);
    EXPECT_EQ(motion.rejected(), 0);
  }
}

/// Ten turns in a thousand steps.
Motion spun(const MovingScene& of, const std::string& rotation) {
  Poses velocities = at_rest(of);
  velocities[0] << 0, 0, 0, -2 * M_PI, 2 * M_PI, 0;
  return Motion(of, {}, undeformed(of), velocities,
                {.time = 10,
                 .stops_at_rest = false,
                 .integrator = classic("displacement: 0.5, rotation: " + rotation)});
}

TEST(Classic, SpinsExactlyWithoutGrowing) {
  const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
  Motion motion = spun(of, "exact");
  run(motion);
  EXPECT_NEAR(gradient_of(motion.poses()[0]).determinant(), 1, 1e-10);
  EXPECT_NEAR(polar_of(gradient_of(motion.poses()[0])).angle, 0, 1e-8);
  EXPECT_NEAR(rigid_part(motion.poses()[0], motion.velocities()[0]).spin / (2 * M_PI), 1, 1e-9);
}

TEST(Classic, GrowsWithEachRotationInFirstOrder) {
  constexpr int steps = 1000;
  const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
  Motion motion = spun(of, "first_order");
  run(motion);
  const double turn = 10 * 2 * M_PI / steps;
  EXPECT_NEAR(gradient_of(motion.poses()[0]).determinant() / std::pow(1 + turn * turn, steps), 1, 1e-9);
  EXPECT_NEAR(rigid_part(motion.poses()[0], motion.velocities()[0]).spin / (2 * M_PI), 1, 1e-9);
  EXPECT_NEAR(motion.ledger().stored.strain / motion.ledger().kinetic, 0, 1e-9) << "growth is no strain";
}

TEST(Classic, SlidesDownAnInclineAsCoulombSays) {
  const double friction = std::tan(20 * M_PI / 180);
  const MovingScene of = on_ground(box(0, 0, 1, 1), friction, inclined(30));
  const double exact = gravity / 2 * (std::sin(M_PI / 6) - friction * std::cos(M_PI / 6));
  for (const double step : {0.01, 0.1}) {
    Motion motion(of, {}, undeformed(of), at_rest(of),
                  {.time = 1, .step = step, .integrator = classic("displacement: 0.2")});
    run(motion);
    EXPECT_NEAR((motion.poses()[1][0] - 0.5) / exact, 1, 2e-4) << step;
    EXPECT_LT(unbalanced(motion, motion.ledger().external), 1e-9);
    EXPECT_NEAR(motion.ledger().friction / (motion.ledger().external - motion.ledger().kinetic), 1, 1e-3);
  }
}

TEST(Classic, SticksWhereFrictionHolds) {
  const MovingScene of = on_ground(box(0, 0, 1, 1), std::tan(35 * M_PI / 180), inclined(30));
  Motion motion(of, {}, undeformed(of), at_rest(of),
                {.time = 2, .stops_at_rest = false, .integrator = classic()});
  run(motion);
  EXPECT_LT(std::abs(motion.poses()[1][0] - 0.5), 1e-5);
}

TEST(Classic, StacksBearTheirWeights) {
  constexpr int count = 10;
  std::vector<MovingBody> bodies{body(box(-5, -1, 5, 0), true)};
  for (int i = 0; i < count; ++i) bodies.push_back(body(box(0, i, 1, i + 1)));
  const MovingScene of = scene(0.5, std::move(bodies), {0, -gravity});
  Motion motion(of, {}, undeformed(of), at_rest(of),
                {.time = 2, .stops_at_rest = false, .integrator = classic("velocity_kept: 0.95")});
  run(motion);
  std::vector<double> below(count, 0.0);
  const MotionMemory memory = motion.memory();
  for (const auto& [key, kept] : memory.sliders.all()) below[std::min(key.body, key.other)] += kept.force;
  for (int i = 0; i < count; ++i) {
    EXPECT_NEAR(below[static_cast<std::size_t>(i)] / (density * gravity * (count - i)), 1, 1e-4);
    EXPECT_NEAR(motion.poses()[static_cast<std::size_t>(i + 1)][0], 0.5, 1e-8);
  }
}

TEST(Classic, BooksCloseWhereBodiesHit) {
  const MovingScene of = on_ground({{{0, 0.3}, {1, 0.5}, {0.8, 1.5}, {-0.2, 1.3}}}, 0.5, {0, -gravity});
  Motion motion(of, {}, undeformed(of), at_rest(of),
                {.time = 1, .stops_at_rest = false, .integrator = classic()});
  const double stored = motion.ledger().stored.sum();
  run(motion);
  const MotionLedger& ledger = motion.ledger();
  EXPECT_NEAR(
      (ledger.kinetic + ledger.stored.sum() - stored + ledger.friction + ledger.lost() + ledger.error) /
          ledger.external,
      1, 1e-12);
  EXPECT_LT(unbalanced(motion, ledger.external), 1e-9);
  EXPECT_GT(ledger.friction, 0);
}

TEST(Classic, StepsAreSoShortThatNoCornerGoesTooFar) {
  const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
  Poses velocities = at_rest(of);
  velocities[0][0] = 1;
  Poses poses = undeformed(of);
  Motion motion(of, {}, poses, velocities,
                {.time = 1, .step = 0.1, .integrator = classic("displacement: 0.02")});
  while (motion.advance()) EXPECT_LE(motion.step().before, 0.02);
  EXPECT_NEAR(motion.poses()[0][0], 1.5, 1e-12);
  EXPECT_EQ(motion.rejected(), 0);
}

TEST(Classic, GoesOnWhereItStoodWithTheSameBits) {
  const MovingScene of =
      scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, 0.1, 1, 1.1)), body(box(0.2, 1.2, 1.2, 2.2))},
            {0, -gravity});
  Poses velocities = at_rest(of);
  velocities[1][0] = 1;
  const MotionCourse course{
      .time = 0.6, .stops_at_rest = false, .integrator = classic("rotation: first_order")};
  Motion whole(of, {}, undeformed(of), velocities, course), later(of, {}, undeformed(of), velocities, course);
  for (int i = 0; i < 80; ++i) ASSERT_TRUE(whole.advance());
  later.restore(whole.memory(), {});
  run(whole);
  run(later);
  EXPECT_EQ(later.time(), whole.time());
  EXPECT_EQ(later.poses(), whole.poses());
  EXPECT_EQ(later.ledger().friction, whole.ledger().friction);
  EXPECT_EQ(later.ledger().impact, whole.ledger().impact);
  EXPECT_EQ(later.ledger().numerical, whole.ledger().numerical);
}

TEST(Classic, GoesWithAGroundThatIsDriven) {
  MovingScene of = on_ground(box(0, 0, 1, 1), 0.5, {0, -gravity});
  of.drives.push_back({{0}, {1, 0}, std::make_shared<Steady>(0.2)});
  Motion motion(of, {}, undeformed(of), at_rest(of),
                {.time = 1, .stops_at_rest = false, .integrator = classic()});
  run(motion);
  EXPECT_NEAR(motion.poses()[1][0], 0.7, 0.2 * 0.2 / (gravity / 2));
  EXPECT_NEAR(motion.ledger().kinetic / (density / 2 * 0.04), 1, 1e-2);
  EXPECT_LT(unbalanced(motion, density), 1e-9);
}

/// What forces in first order miss of those of the potential, where two blocks that are strained and turned, on a spring and
/// an elastic joint, go some way.
double missed_by_first_order(double strain, double way) {
  MovingScene of = scene(0, {body(box(0, 0, 1, 1)), body(box(1, 0, 2, 1))}, {0, -gravity});
  of.springs.push_back({{{0, Vec6(Vec6::Constant(0.5))}, {1, Vec6(Vec6::Constant(-0.4))}}, -0.1, 1e8});
  const auto law =
      interface_laws()
          .choose(parse_yaml("{type: elastic, normal_stiffness: 2e9, shear_stiffness: 1e9}", "test"))
          .make();
  Bond bond;
  bond.second = 1;
  bond.at_first = Vec2(0.5, 0.1);
  bond.at_second = Vec2(-0.5, 0.1);
  bond.normal = Vec2(1, 0);
  bond.stress_first.setZero();
  bond.stress_second.setZero();
  bond.weight = 0.5;
  bond.stiffness = 1e10;
  bond.law = law.get();
  const std::vector<Bond> bonds{bond};
  std::vector<BodyCourse> courses;
  Poses start, ways;
  for (const MovingBody& moved : of.bodies) {
    const Pose y =
        finite_pose(moved.centroid, (Vec6() << 0.01, -0.02, 0.3, strain, -strain, strain).finished());
    start.push_back(y);
    courses.push_back({y, y});
    ways.push_back(way * (Pose() << 0.3, -0.2, 0.5, 0.7, -0.4, 0.1 * moved.centroid.x()).finished());
  }
  const MeetingSearch search(of, {});
  Potential potential(of, search, bonds);
  potential.leave_out_meetings();
  potential.begin(start);
  FirstOrder first_order(of, bonds);
  first_order.begin(courses);
  Poses there = start;
  for (std::size_t b = 0; b < 2; ++b) there[b] += ways[b];
  return (first_order.forces(ways) - potential.gradient(there)).norm();
}

TEST(FirstOrder, IsTheTangentOfThePotentialWhereAStepBegins) {
  EXPECT_LT(missed_by_first_order(1e-4, 0), 1e-10 * 1e-4 * young);
  EXPECT_NEAR(missed_by_first_order(0, 1e-3) / missed_by_first_order(0, 5e-4), 4, 0.02);
  EXPECT_LT(missed_by_first_order(0, 1e-3), 1e-5 * young);
}

std::vector<Meeting> entrances(const MovingScene& of, double reach) {
  const MeetingSearch search(of, {});
  return EntranceSearch(of, search, reach).find(undeformed(of));
}

TEST(Entrances, TwoCornersOfABlockOnAnEqualOne) {
  const MovingScene of = scene(0, {body(box(0, 0, 1, 1), true), body(box(0, 1 - 1e-4, 1, 2))}, {0, -gravity});
  const std::vector<Meeting> found = entrances(of, 0.02);
  ASSERT_EQ(found.size(), 2u);
  for (const Meeting& meeting : found) {
    EXPECT_TRUE(meeting.key.is_corner);
    EXPECT_NEAR(meeting.distance, -1e-4, 1e-12);
    EXPECT_NEAR(std::abs(meeting.normal.y()), 1, 1e-12);
  }
}

TEST(Entrances, CornerOnTheInsideOfAnEdge) {
  const MovingScene of = on_ground(box(0, 0.01, 1, 1), 0, {0, -gravity});
  const std::vector<Meeting> found = entrances(of, 0.02);
  ASSERT_EQ(found.size(), 2u);
  for (const Meeting& meeting : found) {
    EXPECT_FALSE(meeting.key.is_corner);
    EXPECT_EQ(meeting.key.body, 1u);
    EXPECT_NEAR(meeting.distance, 0.01, 1e-12);
    EXPECT_NEAR(meeting.normal.y(), 1, 1e-12);
  }
}

TEST(Entrances, CornersBesideEachOtherMeetWhereTheyAreFarthestOutside) {
  // The upper block is beside the lower one by 0.015 and below its top by 0.005: it passes.
  const MovingScene of =
      scene(0, {body(box(0, 0, 1, 1), true), body(box(1.015, 0.995, 2, 2))}, {0, -gravity});
  const std::vector<Meeting> found = entrances(of, 0.02);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].distance, 0.015, 1e-12);
  EXPECT_NEAR(std::abs(found[0].normal.x()), 1, 1e-12);
}

TEST(Entrances, CornerInANotchIsHeldByBothItsEdges) {
  // A roof of 120° whose tip is 0.001 above the apex of a notch of 150°.
  const double flat = std::tan(M_PI / 12), steep = std::tan(M_PI / 6);
  const Polygon notched{{{-1, 0}, {0, flat}, {1, 0}, {1, 2}, {-1, 2}}};
  const Polygon roof{{{-0.5, flat - 0.5 * steep}, {0.5, flat - 0.5 * steep}, {0, flat + 0.001}}};
  const std::vector<Meeting> found = entrances(scene(0, {body(notched), body(roof)}, {0, 0}), 0.02);
  ASSERT_EQ(found.size(), 2u);
  for (const Meeting& meeting : found) {
    EXPECT_EQ(meeting.key.body, 1u);
    EXPECT_NEAR(meeting.distance, -0.001 * std::cos(M_PI / 12), 1e-12);
  }
}

TEST(Entrances, ThreeBlocksAroundAPointMeetByTheirCommonEdges) {
  const Vec2 middle(0, 0);
  std::vector<Vec2> ends;
  for (int i = 0; i < 6; ++i) ends.emplace_back(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3));
  std::vector<MovingBody> bodies;
  for (std::size_t i = 0; i < 6; i += 2)
    bodies.push_back(body({{middle, ends[i], ends[i + 1], ends[(i + 2) % 6]}}));
  const MovingScene of = scene(0, std::move(bodies), {0, 0});
  const std::vector<Meeting> found = entrances(of, 0.05);
  ASSERT_EQ(found.size(), 6u);  // of each pair at the middle, and at the common edge's other end
  for (const Meeting& meeting : found) {
    EXPECT_NEAR(meeting.distance, 0, 1e-12);
    const Vec2& n = meeting.normal;
    EXPECT_TRUE(std::ranges::any_of(ends, [&](const Vec2& x) { return std::abs(n.dot(x)) < 1e-9; }));
    EXPECT_NEAR(n.dot(place_of(undeformed(of)[meeting.key.body], meeting.at)), 0, 1e-9);
  }
}

/// A contact 1 m beside the centre of one body, on one that stays.
OpenCloseContact contact(State state) {
  OpenCloseContact out;
  out.slider.meeting = {{1, 0, 0, 0, false}, Vec2::Zero(), Vec2::Zero(), {0, 1}, 0, 100};
  out.slider.stiffness = 10;
  out.friction = 0.5;
  out.state = state;
  out.side = -1;  // t = (−1, 0): to the right
  return out;
}

Poses ways(double x, double y) {
  Poses out(2, Pose::Zero());
  out[1].head<2>() << x, y;
  return out;
}

TEST(OpenCloseContact, ChangesItsStateAsThePassAsks) {
  OpenCloseContact open = contact(State::open);
  EXPECT_FALSE(open.change(ways(0, 0.1)));
  EXPECT_TRUE(open.change(ways(0, -0.1)));
  EXPECT_EQ(open.state, State::sticks);
  OpenCloseContact sticks = contact(State::sticks);
  EXPECT_FALSE(sticks.change(ways(0.49, -0.1)));  // 4.9 of 0.5 · 10
  EXPECT_TRUE(sticks.change(ways(0.51, -0.1)));
  EXPECT_EQ(sticks.state, State::slides);
  EXPECT_EQ(sticks.side, -1);
  EXPECT_FALSE(sticks.change(ways(0.6, -0.1)));
  EXPECT_TRUE(sticks.change(ways(-0.1, -0.1))) << "it goes back";
  EXPECT_EQ(sticks.state, State::sticks);
  EXPECT_TRUE(sticks.change(ways(0, 0.1)));
  EXPECT_EQ(sticks.state, State::open);
}

TEST(OpenCloseContact, KeepsWhatItsFrictionBears) {
  OpenCloseContact slides = contact(State::slides);
  slides.slider.bound = 4;  // of the pass before
  EXPECT_FALSE(slides.change(ways(1, -0.1)));
  EXPECT_NEAR(slides.normal_force(ways(1, -0.1)), 10, 1e-12);
  EXPECT_NEAR(slides.shear_force(ways(1, -0.1)), -4, 1e-12);
  EXPECT_NEAR(slides.kept(ways(1, -0.1)), -0.5, 1e-12);
  EXPECT_NEAR(slides.spent(ways(1, -0.1)), 4 * 0.5, 1e-12);
}

}  // namespace
}  // namespace dda
