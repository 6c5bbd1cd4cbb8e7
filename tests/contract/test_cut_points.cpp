// What joints of sides are held to, asked of the points of cuts through blocks.
#include <gtest/gtest.h>

#include <cmath>

#include "models/body/motion.hpp"
#include "support/cut_structure.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

class CutPointContract : public testing::TestWithParam<const char*> {
 protected:
  static constexpr int cases = 10;
  CutPointContract() : structure_({.subdivision = GetParam()}) {}

  /// A rigid motion, small.
  struct Rigid {
    Vec2 shift;
    double turn;
    Vec2 at(const Vec2& x) const { return shift + turn * Vec2(-x.y(), x.x()); }
  };
  Rigid next() { return {random_.point(1), random_.between(-1, 1)}; }

  void set_block(BlockId block, const Rigid& motion, std::vector<double>& d) const {
    const Vec2 u = motion.at(structure_.body().block(block).moments.centroid);
    Eigen::Map<Vec6>(d.data() + 6 * block.value()) << u.x(), u.y(), motion.turn, 0, 0, 0;
  }
  /// What lies right of a cut moves so, relative to what lies left.
  void set_jump(JumpId jump, const Rigid& motion, std::vector<double>& d) const {
    const Cut& cut = structure_.body().cracks->cut_of(jump);
    const Vec2 u = motion.at((cut.start + cut.end) / 2);
    const double length = std::sqrt(structure_.body().block(cut.block).moments.area);
    Eigen::Map<Vec6>(d.data() + 6 * structure_.body().node_of(jump).value()) << u.x(), u.y(),
        length * motion.turn, 0, 0, 0;
  }

  CutStructure structure_;
  Random random_{26};
};

/// A structure cut all through, one piece of which moves as a whole: the points of the cuts feel all of it, no other any.
TEST_P(CutPointContract, RigidMotionOfASeveredPieceIsTheJumpOfTheCutsAlone) {
  const Vec2 foot(11.3, 0), along(0.07, 1);
  ASSERT_GE(structure_.cut_straight(foot, along), 3);
  const Equilibrium equilibrium = structure_.equilibrium();
  const Body& body = structure_.body();
  for (int i = 0; i < cases; ++i) {
    const Rigid motion = next();
    std::vector<double> d(equilibrium.num_unknowns(), 0.0);
    for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b) {
      const BlockId block{b};
      const bool is_right = cross(along, body.block(block).moments.centroid - foot) < 0;
      if (is_right && body.cracks->parts(block).empty()) set_block(block, motion, d);
    }
    for (std::size_t j = 0; j < body.num_jumps(); ++j) set_jump(JumpId{j}, motion, d);
    std::size_t num_cut = 0;
    for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
      const InterfacePoint& point = equilibrium.point(p);
      Vec2 q = Vec2::Zero();
      point.for_each_part([&](BlockId node, const Mat26& rows) {
        q += rows * Eigen::Map<const Vec6>(d.data() + 6 * node.value());
      });
      const Vec2 jump = motion.at(point.x), n = point.normal;
      const Vec2 wanted = point.cut ? Vec2(n.dot(jump), cross(n, jump)) : Vec2(0, 0);
      EXPECT_LT((q - wanted).norm(), 1e-12) << "at " << point.x.transpose();
      num_cut += point.cut.has_value();
    }
    EXPECT_GE(num_cut, 6u);
  }
}

/// Whatever is cut before or after, and moves beside its block: across a cut there is its own jump alone.
TEST_P(CutPointContract, AJumpIsFeltByItsOwnCut) {
  ASSERT_GE(structure_.cut_straight({11.3, 0}, {0.07, 1}) + structure_.cut_straight({12.1, 0}, {0.05, 1}, 2),
            5);
  const Equilibrium equilibrium = structure_.equilibrium();
  const Body& body = structure_.body();
  for (std::size_t j = 0; j < body.num_jumps(); ++j) {
    const Rigid motion = next();
    std::vector<double> d(equilibrium.num_unknowns(), 0.0);
    set_jump(JumpId{j}, motion, d);
    for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
      const InterfacePoint& point = equilibrium.point(p);
      if (point.first != point.second) continue;  // along a side
      const bool is_own = point.jumps.front().node == body.node_of(JumpId{j});
      const Vec2 jump = motion.at(point.x), n = point.normal;
      const Vec2 wanted = is_own ? Vec2(n.dot(jump), cross(n, jump)) : Vec2(0, 0);
      EXPECT_LT((equilibrium.opening(p, d) - wanted).norm(), 1e-12);
    }
  }
}

/// The stiffness of a cut keeps the structure stable beside the sides', whatever its block has to bear besides.
TEST_P(CutPointContract, StiffnessDoesNotDependOnTheDirectionOfTheCut) {
  CutStructure other({.subdivision = GetParam()});
  ASSERT_GE(structure_.cut_straight({11.3, 0}, {0.07, 1}), 3);
  for (const Cut& cut : structure_.cracks().cuts())
    ASSERT_TRUE(other.cracks().cut(cut.block, cut.end, cut.start, 0));
  const Equilibrium one = structure_.equilibrium(), turned = other.equilibrium();
  std::size_t compared = 0;
  for (std::size_t p = 0; p < one.num_active(); ++p)
    for (std::size_t r = 0; r < turned.num_active(); ++r) {
      if (!one.point(p).cut || one.point(p).first != turned.point(r).first ||
          (one.point(p).x - turned.point(r).x).norm() > 1e-9)
        continue;
      EXPECT_GT(one.point(p).stiffness, 0);
      EXPECT_NEAR(turned.point(r).stiffness / one.point(p).stiffness, 1, 1e-12);
      EXPECT_LT((turned.point(r).normal + one.point(p).normal).norm(), 1e-12);
      ++compared;
    }
  EXPECT_GE(compared, 6u);
}

INSTANTIATE_TEST_SUITE_P(Patterns, CutPointContract,
                         testing::Values("{type: voronoi, blocks: 60, seed: 3}",
                                         "{type: triangles, size: 2.5}",
                                         "{type: grid, columns: 12, rows: 4}"),
                         [](const auto& chosen) { return "pattern" + std::to_string(chosen.index); });

}  // namespace
}  // namespace dda
