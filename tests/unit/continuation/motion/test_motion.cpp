// Single bodies and stacks against closed forms.
#include <random>

#include "unit/continuation/motion/blocks.hpp"

namespace dda {
namespace {

TEST(Motion, FallsFreelyAtAnyStep) {
  for (const double step : {0.001, 0.01, 0.1}) {
    const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, -gravity});
    Poses velocities = at_rest(of);
    velocities[0][0] = 2;
    Motion motion(of, {}, undeformed(of), velocities, {.time = 1, .step = step});
    run(motion);
    EXPECT_NEAR(motion.poses()[0][0], 2.5, 1e-9);
    EXPECT_NEAR(motion.poses()[0][1], 0.5 - gravity / 2, 1e-9);
  }
}

/// How fast it is does not matter to a body that meets nothing: of the step itself, a hundredth of √(L/g), it takes as many as
/// one at rest, and those in which it leaves the ground.
TEST(Motion, ShortensItsStepsForWhatCanBeMetAlone) {
  constexpr double speed = 1e5, time = 1, free = time / 0.01 * 3.14;
  const MovingScene of = scene(0.5, {body(box(-2, -1, 3, 0), true), body(box(0, 0, 1, 1))}, {0, -gravity});
  for (const double height : {0.0, 5.0}) {
    Poses start = undeformed(of), velocities = at_rest(of);
    start[1][1] += height;
    velocities[1][0] = speed;
    Motion motion(of, {}, start, velocities, {.time = time, .stops_at_rest = false});
    int steps = 0;
    while (motion.advance()) ++steps;
    EXPECT_EQ(motion.ending(), Motion::Ending::at_time) << motion.reason();
    EXPECT_LT(steps, free + (height > 0 ? 1 : 300));
    EXPECT_NEAR((motion.poses()[1][0] - 0.5) / speed, time, 1e-6);
    EXPECT_NEAR(motion.poses()[1][1] - height, 0.5 - gravity / 2, 1e-2);
  }
}

/// A wall is met however fast and however far away.
TEST(Motion, IsStoppedByAWallFarAway) {
  constexpr double speed = 100, way = 200;
  const MovingScene of =
      scene(0, {body(box(way, -50, way + 1, 50), true), body(box(-1, 0, 0, 1))}, {0, -gravity});
  Poses velocities = at_rest(of);
  velocities[1][0] = speed;
  Motion motion(of, {}, undeformed(of), velocities, {.time = 2.2, .stops_at_rest = false});
  run(motion);
  EXPECT_NEAR(motion.poses()[1][0], way - 0.5, 0.1);
}

TEST(Motion, SpinsWithoutGrowing) {
  const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
  Poses velocities = at_rest(of);
  velocities[0] << 0, 0, 0, -2 * M_PI, 2 * M_PI, 0;
  Motion motion(of, {}, undeformed(of), velocities, {.time = 3, .stops_at_rest = false});
  run(motion);
  EXPECT_NEAR(polar_of(gradient_of(motion.poses()[0])).angle, 0, 1e-7);
  EXPECT_NEAR(gradient_of(motion.poses()[0]).determinant(), 1, 1e-10);
}

TEST(Motion, SlidesDownAnInclineAsCoulombSays) {
  const double friction = std::tan(20 * M_PI / 180);
  const MovingScene of =
      scene(friction, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, inclined(30));
  const double exact = gravity / 2 * (std::sin(M_PI / 6) - friction * std::cos(M_PI / 6));
  for (const double step : {0.01, 0.1}) {
    Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 1, .step = step});
    run(motion);
    EXPECT_NEAR((motion.poses()[1][0] - 0.5) / exact, 1, 2e-4) << step;
    EXPECT_LT(unbalanced(motion, motion.ledger().external), 1e-6);
    EXPECT_FALSE(motion.search().crossing(motion.poses()).has_value());
  }
}

TEST(Motion, SticksForGoodWhereFrictionHolds) {
  const MovingScene of =
      scene(std::tan(35 * M_PI / 180), {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, inclined(30));
  double after = 0;
  for (const double time : {1.0, 10.0}) {
    Motion motion(of, {}, undeformed(of), at_rest(of), {.time = time, .stops_at_rest = false});
    run(motion);
    const double now = motion.poses()[1][0] - 0.5;
    EXPECT_LT(now, 1e-5);
    if (time > 1) {
      EXPECT_NEAR(now, after, 1e-8);
    }
    after = now;
  }
}

TEST(Motion, SlidesToAStopAndRests) {
  const MovingScene of = scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, {0, -gravity});
  Poses velocities = at_rest(of);
  velocities[1][0] = 3;
  Motion motion(of, {}, undeformed(of), velocities, {.time = 20});
  run(motion);
  EXPECT_EQ(motion.ending(), Motion::Ending::at_rest);
  EXPECT_NEAR((motion.poses()[1][0] - 0.5) / (9 / gravity), 1, 1e-4);
  EXPECT_NEAR(motion.ledger().friction / (density / 2 * 9), 1, 1e-2);
}

TEST(Motion, ABodyThatGainsSpeedByFrictionGetsNothingBack) {
  const double friction = std::tan(20 * M_PI / 180), press = std::cos(M_PI / 6) * gravity * density;
  const MovingScene of =
      scene(friction, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, inclined(30));
  for (const double dt : {0.01, 0.05}) {
    Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 1, .stops_at_rest = false, .step = dt});
    run(motion);
    const MotionLedger& ledger = motion.ledger();
    EXPECT_GT(ledger.lost(), -1e-4 * ledger.external) << dt;
    EXPECT_NEAR(ledger.friction / (friction * press * (motion.poses()[1][0] - 0.5)), 1, 3 * dt) << dt;
  }
}

TEST(Motion, AVibrationAboutALoadGivesNothingBack) {
  MovingBody soft = body(box(0, 0, 1, 1));
  soft.block.stiffness *= 1e-4;
  const MovingScene of = scene(0, {body(box(-5, -1, 9, 0), true), soft}, {0, -gravity});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 1, .stops_at_rest = false, .step = 2e-3});
  double fallen = 0, largest = 0, before = 0;
  while (motion.advance()) {
    const MotionLedger& ledger = motion.ledger();
    fallen += std::max(0.0, before - ledger.lost());
    largest = std::max(largest, std::abs(ledger.external));
    before = ledger.lost();
  }
  EXPECT_GT(motion.ledger().stored.strain, 0);
  EXPECT_LT(fallen / largest, 2e-3);
}

/// Where an implicit step has stopped a vibration that it does not resolve, forces at its end are large: they have done
/// what they do, whatever the length of the next step.
TEST(Motion, AStepThatIsCutGivesAVibrationNothing) {
  constexpr double dt = 1e-2, per_step = 1, speed = 0.1;  // ω dt
  MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
  const double stiffness = of.bodies[0].block.mass * std::pow(per_step / dt, 2);
  of.springs.push_back({.rows = {{0, Pose::Unit(0)}}, .length = 0.5, .stiffness = stiffness});
  Poses velocities = at_rest(of);
  velocities[0][0] = speed;
  const double pace = pace_of(of, pull_on(of, velocities));
  for (int steps = 2; steps < 9; ++steps) {
    Motion motion(of, {}, undeformed(of), velocities,
                  {.time = (steps + 1e-3) * dt, .stops_at_rest = false, .step = dt / pace});
    double before = 0, after = motion.ledger().kinetic;
    while (motion.advance()) {
      before = after;
      after = motion.ledger().kinetic + motion.ledger().stored.sum();
    }
    EXPECT_LT(motion.step().before, 0.01 * dt);
    EXPECT_LE(after, (1 + 1e-3) * before) << steps;
    EXPECT_GT(after, 0.5 * before) << steps;
  }
}

TEST(Motion, StacksBearTheirWeights) {
  constexpr int count = 20;
  std::vector<MovingBody> bodies{body(box(-5, -1, 5, 0), true)};
  for (int i = 0; i < count; ++i) bodies.push_back(body(box(0, i, 1, i + 1)));
  const MovingScene of = scene(0.5, std::move(bodies), {0, -gravity});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 2, .stops_at_rest = false, .step = 0.06});
  run(motion);
  std::vector<double> below(count, 0.0);
  for (const Meeting& meeting : motion.meetings())
    below[std::min(meeting.key.body, meeting.key.other)] +=
        std::abs(meeting.normal.y()) *
        of.meeting.law->respond(of.meeting.reach - meeting.distance, meeting.stiffness, of.meeting.reach)
            .force;
  for (int i = 0; i < count; ++i) {
    EXPECT_NEAR(below[static_cast<std::size_t>(i)] / (density * gravity * (count - i)), 1, 1e-4);
    EXPECT_NEAR(motion.poses()[static_cast<std::size_t>(i + 1)][0], 0.5, 1e-8);
  }
}

TEST(Motion, TopplesWhereTheResultantLeavesTheBase) {
  const auto topples = [](double degrees) {
    const MovingScene of =
        scene(2, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 0.5, 1))}, inclined(degrees));
    Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 2.5, .stops_at_rest = false});
    while (motion.advance() && std::abs(polar_of(gradient_of(motion.poses()[1])).angle) < 0.2) {
    }
    return motion.ending() == Motion::Ending::none;
  };
  const double exact = std::atan(0.5) * 180 / M_PI;
  EXPECT_FALSE(topples(exact - 0.1));
  EXPECT_TRUE(topples(exact + 0.1));
}

TEST(Motion, GivesBackWhatIsPressedAtTheBeginning) {
  const MovingScene of = scene(0, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, {0, 0});
  Poses poses = undeformed(of);
  poses[1][1] -= offset / 2;
  Motion motion(of, {}, poses, at_rest(of), {.time = 0.01, .stops_at_rest = false, .step = 0.01});
  const double pressed = motion.ledger().stored.contact;
  EXPECT_GT(pressed, 0);
  run(motion);
  const MotionLedger& ledger = motion.ledger();
  EXPECT_GT(ledger.kinetic, 0);
  EXPECT_NEAR((ledger.kinetic + ledger.stored.sum() + ledger.lost()) / pressed, 1, 1e-6);
}

TEST(Motion, FallsAtAnyIntegratorThatHasInertia) {
  for (const auto& [name, bound] :
       {std::pair("free_flight", 1e-9), {"implicit_euler", 0.02}, {"trapezoidal", 1e-9}}) {
    const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, -gravity});
    Poses velocities = at_rest(of);
    velocities[0][0] = 2;
    Motion motion(of, {}, undeformed(of), velocities, {.time = 1, .integrator = integrator(name)});
    run(motion);
    EXPECT_NEAR(motion.poses()[0][0], 2.5, 1e-9) << name;
    EXPECT_NEAR((motion.poses()[0][1] - 0.5) / (-gravity / 2), 1, bound) << name;
    EXPECT_NEAR(motion.ledger().kinetic / (motion.ledger().external + density * 2), 1, 0.03) << name;
    EXPECT_LT(unbalanced(motion, motion.ledger().external), 1e-6) << name;
  }
}

TEST(Motion, SwingsWithoutLossAtSecondOrder) {
  constexpr double stiffness = 1e6;
  const double period = 2 * M_PI * std::sqrt(density / stiffness);
  std::vector<double> late;
  for (const double step : {0.001, 0.0005}) {
    MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
    Vec6 along = Vec6::Zero();
    along[0] = 1;
    of.springs.push_back({{{0, along}}, 0.5, stiffness});
    Poses velocities = at_rest(of);
    velocities[0][0] = 0.1;
    Motion motion(
        of, {}, undeformed(of), velocities,
        {.time = 5 * period, .stops_at_rest = false, .step = step, .integrator = integrator("trapezoidal")});
    const double energy = motion.ledger().kinetic;
    run(motion);
    EXPECT_NEAR((motion.ledger().kinetic + motion.ledger().stored.springs) / energy, 1, 1e-9);
    late.push_back(std::abs(motion.poses()[0][0] - 0.5));
  }
  EXPECT_NEAR(std::log2(late[0] / late[1]), 2, 0.2);
}

TEST(Motion, SettlesWithoutInertia) {
  std::vector<MovingBody> bodies{body(box(-5, -1, 5, 0), true)};
  for (int i = 0; i < 3; ++i)
    bodies.push_back(body(box(0.1 * i, i + 0.002 * (i + 1), 1 + 0.1 * i, i + 1 + 0.002 * (i + 1))));
  const MovingScene of = scene(0.5, std::move(bodies), {0, -gravity});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 100, .integrator = integrator("settle")});
  run(motion);
  EXPECT_EQ(motion.ending(), Motion::Ending::at_rest) << motion.reason();
  EXPECT_NEAR(motion.poses()[3][1], 2.5, 1e-4);
  EXPECT_EQ(motion.ledger().kinetic, 0);
  EXPECT_NEAR((motion.ledger().stored.sum() + motion.ledger().lost() + motion.ledger().friction) /
                  motion.ledger().external,
              1, 1e-6);
}

TEST(Motion, GoesWithAGroundThatIsDriven) {
  MovingScene of = scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, {0, -gravity});
  of.drives.push_back({{0}, {1, 0}, std::make_shared<Steady>(0.2)});
  of.drives.push_back({{0}, {0, 1}, std::make_shared<Steady>(0.5)});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 1, .stops_at_rest = false});
  run(motion);
  EXPECT_NEAR(motion.poses()[0][1], 0, 1e-12);  // −0.5 + 0.5
  EXPECT_NEAR(motion.poses()[1][1], 1, 1e-3);
  EXPECT_NEAR(motion.poses()[1][0], 0.7, 0.2 * 0.2 / (gravity / 2));
  EXPECT_NEAR(motion.ledger().kinetic, density / 2 * (0.04 + 0.25), 10);
  EXPECT_LT(unbalanced(motion, density), 1e-6);
}

TEST(Motion, ABodyThatSticksTakesWhatASwingingGroundGives) {
  MovingScene of = scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, {0, -gravity});
  of.drives.push_back({{0}, {1, 0}, std::make_shared<Swing>(0.2 * gravity, 1)});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 0.9, .stops_at_rest = false});
  double most = 0, apart = 0;
  while (motion.advance()) {
    most = std::max(most, motion.ledger().kinetic);
    apart = std::max(apart, std::abs(motion.ledger().external - motion.ledger().kinetic));
  }
  EXPECT_GT(most, 100);
  EXPECT_LT(apart, 3e-4 * most);
  EXPECT_LT(std::abs(motion.ledger().lost()), 3e-4 * most);
}

/// About its corner, in a gravity that tilts it over: ω² = 2 m g (way of the centroid along it) / I.
TEST(Motion, ABodyThatRocksKeepsItsEnergy) {
  constexpr double breadth = 0.5, height = 1, degrees = 40;
  for (const double step : {0.01, 0.005}) {
    const MovingScene of =
        scene(1.2, {body(box(-5, -1, 9, 0), true), body(box(0, 0, breadth, height))}, inclined(degrees));
    Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 2, .stops_at_rest = false, .step = step});
    const auto angle = [&] { return polar_of(gradient_of(motion.poses()[1])).angle; };
    while (angle() > -0.6 && motion.advance()) {
    }
    const MotionLedger& ledger = motion.ledger();
    EXPECT_LT(std::abs(ledger.lost()), 1e-4 * ledger.kinetic);
    EXPECT_NEAR(ledger.kinetic / ledger.external, 1, 1e-3);
  }
}

TEST(Motion, IsDraggedByAGroundThatSetsOutAtOnce) {
  MovingScene of = scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, {0, -gravity});
  of.drives.push_back({{0}, {1, 0}, std::make_shared<Steady>(0.8)});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 0.1, .stops_at_rest = false});
  run(motion);
  EXPECT_NEAR((motion.poses()[1][0] - 0.5) / (0.5 * gravity * 0.01 / 2), 1, 0.05);
  EXPECT_EQ(motion.rejected(), 0);
}

/// Courses of five, four and three bricks, of stone a thousand times as stiff, on a ground that swings with 0.6 g and
/// bears 0.3 g by friction: no brick has a reason to slip on another, which bears 0.7 of its force.
TEST(Motion, IsNotAtRestBeforeWhatIsDrivenIs) {
  class Late final : public TimeFunction {
   public:
    double at(double time) const override { return std::clamp(time - 0.8, 0.0, 0.2); }
  };
  MovingScene of = scene(0.6, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 0.3))}, {0, -gravity});
  of.drives.push_back({{0}, {1, 0}, std::make_shared<Late>()});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 5});
  run(motion);
  EXPECT_EQ(motion.ending(), Motion::Ending::at_rest);
  EXPECT_GT(motion.time(), 1);
  EXPECT_NEAR(motion.poses()[0][0], 2.2, 1e-12);
}

TEST(Motion, StiffBricksSlideOnTheGroundAsOneBody) {
  constexpr double stiffer = 1000, breadth = 0.5, rise = 0.25;
  std::vector<MovingBody> bodies{body(box(-2, -0.5, 4, 0), true)};
  for (int course = 0; course < 3; ++course)
    for (int brick = 0; brick < 5 - course; ++brick) {
      const double left = (brick + course / 2.0) * breadth, low = course * rise;
      bodies.push_back(body(box(left, low, left + breadth, low + rise)));
    }
  for (MovingBody& of : bodies) {
    of.block.stiffness *= stiffer;
    of.modulus *= stiffer;
  }
  MovingScene of = scene(0.7, std::move(bodies), {0, -gravity});
  of.meeting.friction = [](std::size_t first, std::size_t second) {
    return first == 0 || second == 0 ? 0.3 : 0.7;
  };
  of.drives.push_back({{0}, {1, 0}, std::make_shared<Swing>(0.6 * gravity, 1.5)});
  Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 2, .stops_at_rest = false});
  run(motion);
  const auto way = [&](std::size_t b) { return motion.poses()[b][0] - of.bodies[b].centroid.x(); };
  EXPECT_GT(std::abs(way(1) - way(0)), 0.03);
  for (std::size_t b = 2; b < of.num_bodies(); ++b) EXPECT_NEAR(way(b), way(1), 1e-4) << b;
}

TEST(Motion, GoesOnWhereItStoodWithTheSameBits) {
  const MovingScene of =
      scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, 0.1, 1, 1.1)), body(box(0.2, 1.2, 1.2, 2.2))},
            {0, -gravity});
  Poses velocities = at_rest(of);
  velocities[1][0] = 1;
  const MotionCourse course{.time = 0.6, .stops_at_rest = false};
  Motion whole(of, {}, undeformed(of), velocities, course), later(of, {}, undeformed(of), velocities, course);
  for (int i = 0; i < 80; ++i) ASSERT_TRUE(whole.advance());
  later.restore(whole.memory(), {});
  run(whole);
  run(later);
  EXPECT_EQ(later.time(), whole.time());
  EXPECT_EQ(later.poses(), whole.poses());
  EXPECT_EQ(later.ledger().friction, whole.ledger().friction);
}

TEST(Motion, NothingCrossesWhateverIsThrown) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> part(-1, 1);
    std::vector<MovingBody> bodies{body(box(-6, -1, 6, 0), true), body(box(-6, 0.01, -5, 8), true),
                                   body(box(5, 0.01, 6, 8), true)};
    for (int i = 0; i < 6; ++i) {
      Polygon outline;
      const Vec2 centre(3 * part(random), 1.2 + 1.6 * i);
      const int corners = 3 + i % 4;
      for (int k = 0; k < corners; ++k) {
        const double angle = 2 * M_PI * (k + 0.3 * part(random)) / corners;
        outline.vertices.push_back(centre + 0.6 * Vec2(std::cos(angle), std::sin(angle)));
      }
      bodies.push_back(body(outline));
    }
    const MovingScene of = scene(0.4, std::move(bodies), {0, -gravity});
    Poses velocities = at_rest(of);
    for (std::size_t b = 3; b < of.num_bodies(); ++b) {
      const double spin = 3 * part(random);
      velocities[b] << 4 * part(random), 2 * part(random), 0, -spin, spin, 0;
    }
    Motion motion(of, {}, undeformed(of), velocities, {.time = 1.5, .step = seed % 2 ? 0.1 : 0.01});
    double released = 0;
    while (motion.advance()) {
      ASSERT_FALSE(motion.search().crossing(motion.poses()).has_value())
          << "seed " << seed << ", time " << motion.time();
      released = std::max(released, motion.ledger().kinetic);
    }
    EXPECT_NE(motion.ending(), Motion::Ending::failed) << motion.reason();
    EXPECT_LT(unbalanced(motion, released), 1e-4);
  }
}

}  // namespace
}  // namespace dda
