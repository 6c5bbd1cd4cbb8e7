// Damping, losses and initial stress against closed forms.
#include "unit/continuation/motion/blocks.hpp"

namespace dda {
namespace {

/// A vibration x(t) = x₀ exp(−ξ ω t) …, ξ = (a/ω + b ω)/2: what is left of its energy after some periods.
void expect_energy_left(const MotionLedger& ledger, double energy, double exponent) {
  EXPECT_NEAR((ledger.kinetic + ledger.stored.sum()) / energy, std::exp(-2 * exponent), 2e-3);
  const double lost = ledger.lost() + ledger.error;
  EXPECT_NEAR(lost / energy, 0, 1e-5);
  EXPECT_NEAR((ledger.kinetic + ledger.stored.sum() + ledger.damping + lost) / energy, 1, 1e-9);
}

TEST(Damping, SwingsAtTheRatioOfItsDamping) {
  constexpr double stiffness = 1e6, periods = 5;
  const double frequency = std::sqrt(stiffness / density);
  for (const DampingRates& rates :
       {DampingRates{0.02 * frequency, 0}, {0, 0.02 / frequency}, {0.01 * frequency, 0.02 / frequency}}) {
    MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
    Vec6 along = Vec6::Zero();
    along[0] = 1;
    of.springs.push_back({{{0, along}}, 0.5, stiffness});
    Poses velocities = at_rest(of);
    velocities[0][0] = 0.1;
    Motion motion(of, {}, undeformed(of), velocities,
                  {.time = periods * 2 * M_PI / frequency,
                   .stops_at_rest = false,
                   .step = 0.0005,
                   .integrator = integrator("trapezoidal"),
                   .damping = rates});
    const double energy = motion.ledger().kinetic;
    run(motion);
    const double ratio = (rates.mass / frequency + rates.stiffness * frequency) / 2;
    expect_energy_left(motion.ledger(), energy, ratio * 2 * M_PI * periods);
  }
}

/// Of a square that swells and shrinks alike in both directions: ω² = 12 E/((1 − ν) ρ L²).
TEST(Damping, DampsStrainsByTheirRates) {
  constexpr double nu = 0.2, periods = 5;
  const double frequency = std::sqrt(12 * young / ((1 - nu) * density)), rate = 0.02 / frequency;
  const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
  Poses velocities = at_rest(of);
  velocities[0] = pose_of({0, 0}, 1e-3 * Mat2::Identity());
  Motion motion(of, {}, undeformed(of), velocities,
                {.time = periods * 2 * M_PI / frequency,
                 .stops_at_rest = false,
                 .integrator = integrator("trapezoidal"),
                 .damping = {0, rate}});
  const double energy = motion.ledger().kinetic;
  run(motion);
  expect_energy_left(motion.ledger(), energy, rate * frequency / 2 * 2 * M_PI * periods);
}

TEST(Damping, DampsFlightByMassAndNoRotationByStiffness) {
  constexpr double spin = 2, rate = 0.5;
  for (const DampingRates& rates : {DampingRates{0, 1e-3}, {rate, 0}}) {
    const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
    Poses velocities = at_rest(of);
    velocities[0] = rate_of(of.bodies[0].undeformed(), {{3, 0}, spin});
    Motion motion(of, {}, undeformed(of), velocities,
                  {.time = 2, .stops_at_rest = false, .step = 0.005, .damping = rates});
    run(motion);
    const double left = std::exp(-rates.mass * 2);
    const double middle = left * std::exp(rates.mass * motion.step().before / 2);
    EXPECT_NEAR(motion.velocities()[0][0] / (3 * middle), 1, 1e-3 * rates.mass + 1e-9);
    EXPECT_NEAR(rigid_part(motion.poses()[0], motion.velocities()[0]).spin / (spin * middle), 1,
                1e-3 * rates.mass + 1e-4);
  }
}

/// v₀ exp(−a t) and the fall y = −g/a (t − (1 − exp(−a t))/a), whatever the step; all that is spent is damping.
TEST(Damping, SlowsFlightAsClosedFormsSay) {
  constexpr double rate = 0.5, speed = 3;
  constexpr int steps = 100;
  for (const double step : {0.003, 0.03})
    for (const double pull : {0.0, gravity}) {
      const MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, -pull});
      Poses velocities = at_rest(of);
      velocities[0][0] = speed;
      const double dt = step * pace_of(of, pull_on(of, velocities)), time = steps * dt;
      Motion motion(of, {}, undeformed(of), velocities,
                    {.time = time, .stops_at_rest = false, .step = step, .damping = {rate, 0}});
      run(motion);
      const double left = std::exp(-rate * time), gone = (1 - left) / rate, middle = time - dt / 2,
                   mean = std::sinh(rate * dt / 2) / (rate * dt / 2);
      EXPECT_NEAR((motion.poses()[0][0] - 0.5) / (speed * gone), 1, 1e-6) << step;
      EXPECT_NEAR(motion.velocities()[0][0] / (speed * mean * std::exp(-rate * middle)), 1, 1e-6) << step;
      EXPECT_NEAR((0.5 - motion.poses()[0][1]) / (gravity / rate * (time - gone)), pull > 0 ? 1 : 0, 1e-6);
      EXPECT_NEAR(motion.ledger().lost() / motion.ledger().damping, 0, 1e-3) << step;
    }
}

/// What falls on the ground and stays there has lost its energy to the impact; what a spring swings, to the steps.
TEST(Motion, TellsWhatImpactsTakeFromWhatTheStepsDo) {
  constexpr double height = 0.5;
  const MovingScene falls =
      scene(0.5, {body(box(-5, -1, 9, 0), true), body(box(0, height, 1, 1 + height))}, {0, -gravity});
  Motion fallen(falls, {}, undeformed(falls), at_rest(falls), {.time = 1, .stops_at_rest = false});
  run(fallen);
  EXPECT_NEAR(fallen.ledger().impact / (density * gravity * height), 1, 1e-2);
  EXPECT_NEAR(fallen.ledger().numerical / (density * gravity * height), 0, 1e-2);
  MovingScene swings = scene(0.5, {body(box(0, 0, 1, 1))}, {0, 0});
  swings.springs.push_back({.rows = {{0, Pose::Unit(0)}}, .length = 0.5, .stiffness = density});
  Poses velocities = at_rest(swings);
  velocities[0][0] = 1;
  Motion swung(swings, {}, undeformed(swings), velocities, {.time = 20, .stops_at_rest = false});
  run(swung);
  EXPECT_EQ(swung.ledger().impact, 0);
  EXPECT_GT(swung.ledger().numerical, 0.01 * density);
}

/// A stress without strain turns with its block, and drives no motion where joints and neighbours bear it: a block under
/// it alone takes the strain that cancels it.
TEST(Motion, InitialStressTurnsWithItsBlock) {
  MovingScene of = scene(0, {body(box(0, 0, 1, 1))}, {0, 0});
  of.bodies[0].block.initial_stress = Vec3(2e6, -1e6, 5e5);
  const Vec3 strain = -of.bodies[0].block.stiffness.inverse() * of.bodies[0].block.initial_stress;
  const Mat2 free = (Mat2() << strain[0], strain[2] / 2, strain[2] / 2, strain[1]).finished();
  for (const double angle : {0.0, 1.0}) {
    const Pose at = pose_of(of.bodies[0].centroid, rotation(angle) * (Mat2::Identity() + free));
    Motion motion(of, {}, {at}, at_rest(of), {.time = 1, .integrator = integrator("settle")});
    run(motion);
    EXPECT_NEAR((motion.poses()[0] - at).norm() / strain.norm(), 0, 1e-3);
    EXPECT_NEAR(polar_of(gradient_of(motion.poses()[0])).angle, angle, 1e-9);
  }
}

}  // namespace
}  // namespace dda
