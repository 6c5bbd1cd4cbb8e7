// What the energy book of a motion says of impacts, step by step.
#include "unit/continuation/motion/blocks.hpp"

namespace dda {
namespace {

/// The smallest and the largest of what impacts and steps take in one step.
struct Entries {
  double least_impact = 0, most_impact = 0, least_numerical = 0;
};

Entries entries_of(Motion& motion) {
  Entries out;
  for (MotionLedger before = motion.ledger(); motion.advance(); before = motion.ledger()) {
    const double impact = motion.ledger().impact - before.impact;
    out.least_impact = std::min(out.least_impact, impact);
    out.most_impact = std::max(out.most_impact, impact);
    out.least_numerical = std::min(out.least_numerical, motion.ledger().numerical - before.numerical);
  }
  EXPECT_NE(motion.ending(), Motion::Ending::failed) << motion.reason();
  return out;
}

/// Ground that gains speed drags a block along by friction, which a shorter step at the end does not change: that it is
/// dragged and rubbed from the middle of one step to that of the next is neither an impact nor damping.
TEST(EnergyBook, AShorterStepOfABlockThatIsDraggedIsNoImpact) {
  MovingScene of = scene(0.5, {body(box(-2, -0.5, 3, 0), true), body(box(0, 0, 1, 1))}, {0, -gravity});
  of.drives.push_back({{0}, {1, 0}, std::make_shared<Swing>(8, 1e-3)});
  const double dt = 0.01 * pace_of(of, gravity);
  for (const double last : {0.1, 0.6}) {
    Motion motion(of, {}, undeformed(of), at_rest(of), {.time = (150 + last) * dt, .stops_at_rest = false});
    const Entries entries = entries_of(motion);
    EXPECT_LT(motion.step().before, 0.99 * dt);
    const double kinetic = motion.ledger().kinetic;
    EXPECT_GT(kinetic, 0.1 * density);
    EXPECT_GE(entries.least_impact, 0);
    EXPECT_LT(entries.most_impact, 1e-5 * kinetic);
    EXPECT_GT(entries.least_numerical, -1e-4 * kinetic);
  }
}

/// Where both ends of a step share in its forces they share in what friction spends: a block that slides gives nothing back,
/// and what has moved is rubbed.
TEST(EnergyBook, FrictionSpendsByTheForcesOfTheWholeStep) {
  const MovingScene of = scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, 0, 1, 1))}, {0, -gravity});
  Poses velocities = at_rest(of);
  velocities[1][0] = 3;
  const double begun = density / 2 * 9;
  for (const char* name : {"free_flight", "implicit_euler", "trapezoidal"}) {
    Motion motion(of, {}, undeformed(of), velocities,
                  {.time = 0.3, .stops_at_rest = false, .integrator = integrator(name)});
    double given = 0;
    for (double before = 0; motion.advance(); before = motion.ledger().lost())
      given += std::max(0.0, before - motion.ledger().lost());
    EXPECT_LT(given, 2e-3 * begun) << name;
    EXPECT_GT(motion.ledger().friction, 0.5 * (begun - motion.ledger().kinetic)) << name;
  }
}

/// Contacts that ring take and seem to give again: what they give is none of an impact, and none of it is taken twice.
TEST(EnergyBook, ImpactsNeverGive) {
  constexpr double height = 0.1;
  const MovingScene of =
      scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, height, 1, 1 + height))}, {0, -gravity});
  for (const char* name : {"free_flight", "implicit_euler", "trapezoidal", "settle"}) {
    Motion motion(of, {}, undeformed(of), at_rest(of),
                  {.time = 0.5, .stops_at_rest = false, .integrator = integrator(name)});
    EXPECT_GE(entries_of(motion).least_impact, 0) << name;
    EXPECT_LT(motion.ledger().impact, 1.1 * density * gravity * height) << name;
  }
}

}  // namespace
}  // namespace dda
