#include <gtest/gtest.h>

#include "models/locked_joints.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

/// Two blocks below, split at x = `corner`, and two above, split at x = 1; `joint` joins those below to those
/// above, `head` the two above to each other.
std::string courses(double corner, const std::string& joint, const std::string& head = "bonded") {
  const std::string x = std::to_string(corner);
  return R"(
scene:
  regions:
    - {name: a, material: stone, vertices: [[0, 0], [)" +
         x + ", 0], [" + x + R"(, 1], [0, 1]]}
    - {name: b, material: stone, vertices: [[)" +
         x + ", 0], [2, 0], [2, 1], [" + x + R"(, 1]]}
    - {name: c, material: brick, vertices: [[0, 1], [1, 1], [1, 2], [0, 2]]}
    - {name: d, material: brick, vertices: [[1, 1], [2, 1], [2, 2], [1, 2]]}
  boundaries: {foot: [[0, 0], [2, 0]]}
thickness: 1
materials:
  stone: {type: linear_elastic, young_modulus: 1000, poisson_ratio: 0.2}
  brick: {type: linear_elastic, young_modulus: 2000, poisson_ratio: 0.2}
interfaces:
  bed: {between: [stone, brick], law: {type: friction, friction_angle: 30}, )" +
         joint + R"(}
  head: {between: [brick, brick], law: {type: )" +
         head + R"(}, treatment: )" + (head == "bonded" ? "consistent" : "lagrange") + R"(}
  foot: {between: [stone, stone], law: {type: bonded}, treatment: consistent}
supports:
  foot: {boundary: foot, fix: xy}
stages:
  - {name: load, loads: [{type: point_load, at: [0, 2], force: [0, -1]}]}
)";
}

std::size_t locked(const std::string& deck) {
  const Structure structure(deck);
  const Equilibrium equilibrium = structure.equilibrium();
  return locked_joints(structure.body(), equilibrium.interfaces()).size();
}

TEST(LockedJoints, AreThoseWhoseCornersDoNotMeet) {
  for (const std::string treatment : {"lagrange", "augmented_lagrangian"}) {
    EXPECT_EQ(locked(courses(1, "treatment: " + treatment)), 0u) << "corners meet";
    EXPECT_EQ(locked(courses(0.9, "treatment: " + treatment)), 1u) << "one within a side";
  }
}

TEST(LockedJoints, NeedTwoExactPointsOnAPiece) {
  EXPECT_EQ(locked(courses(0.9, "treatment: lagrange, points: midpoint")), 0u);
  EXPECT_EQ(locked(courses(0.9, "treatment: consistent")), 0u);
  EXPECT_EQ(locked(courses(0.9, "treatment: penalty")), 0u);
}

std::string notice(const std::string& deck) {
  const Structure structure(deck);
  const Equilibrium equilibrium = structure.equilibrium();
  const auto notices = locked_joints(structure.body(), equilibrium.interfaces());
  return notices.size() == 1 ? notices.front() : "";
}

/// Two bonded bricks on one stone lock as two bonded stones under one brick do; bricks free to part do not.
TEST(LockedJoints, CountPlacesBetweenBondedBlocks) {
  const std::string bonded = notice(courses(0.9, "treatment: lagrange"));
  EXPECT_NE(bonded.find("interface 'bed' locks: at ("), std::string::npos) << bonded;
  EXPECT_NE(bonded.find("and 1 more place a"), std::string::npos) << bonded;
  const std::string free = notice(courses(0.9, "treatment: lagrange", "friction, friction_angle: 30"));
  EXPECT_NE(free.find("at (0.9, 1) a corner"), std::string::npos) << free;
}

}  // namespace
}  // namespace dda
