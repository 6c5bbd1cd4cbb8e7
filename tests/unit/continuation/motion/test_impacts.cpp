// What impacts leave.
#include "unit/continuation/motion/blocks.hpp"

namespace dda {
namespace {

TEST(Motion, GivesBackWhatRestitutionSays) {
  for (const double share : {0.0, 0.5, 1.0}) {
    MovingScene of = scene(0, {body(box(-5, -1, 9, 0), true), body(box(0, 1, 1, 2))}, {0, -gravity});
    of.meeting.restitution = [share](std::size_t, std::size_t) { return share; };
    Motion motion(of, {}, undeformed(of), at_rest(of), {.time = 1.2, .stops_at_rest = false, .step = 0.005});
    double highest = 0, spent = 0;
    while (motion.advance()) {
      if (motion.time() > std::sqrt(2 / gravity) + 0.02)
        highest = std::max(highest, motion.poses()[1][1] - 0.5);
      EXPECT_GE(motion.ledger().lost(), spent - 1e-6 * gravity * density)
          << "what may be given back is not spent yet";
      spent = motion.ledger().lost();
    }
    EXPECT_NEAR(std::sqrt(highest), share, 0.03) << motion.reason();
    EXPECT_LT(unbalanced(motion, motion.ledger().external), 1e-6);
    EXPECT_GE(motion.ledger().lost(), -1e-9 * density);
  }
}

/// On its narrow foot, from corner to corner: Housner's ω₊/ω₋ = 1 − 3/2 sin² α, tan α = breadth/height, by the energy over
/// that of standing, E₊/E₋ = (ω₊/ω₋)², whatever the step. What the impact has taken it gives nothing of back.
TEST(Motion, ASlenderBodyRocksAsHousnerSays) {
  constexpr double breadth = 1, height = 5, tilt = 0.1;
  const double sine = breadth / std::hypot(breadth, height), ratio = 1 - 1.5 * sine * sine;
  const MovingScene of =
      scene(1, {body(box(-9, -1, 9, 0), true), body(box(-breadth, 0, 0, height))}, {0, -gravity});
  Poses poses = undeformed(of);
  poses[1] = pose_of(rotation(-tilt) * centre_of(poses[1]), rotation(-tilt));
  const double begun = density * breadth * height * gravity * (centre_of(poses[1]).y() - height / 2);
  for (const double step : {1e-3, 1e-2}) {
    Motion motion(of, {}, poses, at_rest(of), {.time = 1.5, .stops_at_rest = false, .step = step});
    double fallen = 0, before = 0;
    while (motion.advance()) {
      const MotionLedger& ledger = motion.ledger();
      fallen += std::max(0.0, before - ledger.lost());
      before = ledger.lost();
    }
    EXPECT_GT(polar_of(gradient_of(motion.poses()[1])).angle, 0) << "once over";
    EXPECT_NEAR(std::sqrt((begun - motion.ledger().lost()) / begun), ratio, 0.01) << step;
    EXPECT_LT(fallen, 1e-3 * begun) << step;
  }
}

/// Where a corner that is pressed begins to vibrate the body gets no spin: it turns about it as a rigid one, however short the
/// steps are, φ̈ = m g r sin(α − φ₀) / I about the corner.
TEST(Motion, ABodyThatVibratesOnItsCornerTurnsAsARigidOne) {
  constexpr double breadth = 1, height = 5, tilt = 0.1, time = 0.1;
  MovingBody soft = body(box(-breadth, 0, 0, height));
  soft.block.stiffness *= 0.1;
  const MovingScene of = scene(5, {body(box(-9, -1, 9, 0), true), soft}, {0, -gravity});
  Poses poses = undeformed(of);
  poses[1] = pose_of(rotation(-tilt) * centre_of(poses[1]), rotation(-tilt));
  const double r = std::hypot(breadth, height) / 2, about_corner = 4 * r * r / 3,
               rigid = gravity * r * std::sin(std::atan2(breadth, height) - tilt) / about_corner * time *
                       time / 2;
  for (const double step : {1e-3, 1e-2}) {
    Motion motion(of, {}, poses, at_rest(of), {.time = time, .stops_at_rest = false, .step = step});
    while (motion.advance()) {
    }
    EXPECT_NEAR((polar_of(gradient_of(motion.poses()[1])).angle + tilt) / rigid, 1, 0.02) << step;
  }
}

}  // namespace
}  // namespace dda
