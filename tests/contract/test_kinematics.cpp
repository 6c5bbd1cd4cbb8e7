// What every choice of kinematics keeps to: rows that are the derivatives of each other, whatever the order of the blocks.
#include <gtest/gtest.h>

#include "models/body/motion.hpp"
#include "models/kinematics/kinematics.hpp"
#include "support/structure.hpp"

namespace dda {
namespace {

std::vector<std::string> known() {
  std::vector<std::string> out;
  for (const FamilyMember* member : kinematics().entries()) out.push_back(member->name);
  return out;
}

class KinematicsContract : public testing::TestWithParam<std::string> {
 protected:
  Structure structure() const {
    return Structure(
        "scene: {regions: [{name: body, material: stone, vertices: [[0, 0], [4, 0], [3, 2], [0, 3]]}], "
        "subdivision: {type: voronoi, blocks: 6, seed: 2}}\n"
        "thickness: 1\nkinematics: " +
        GetParam() +
        "\nmaterials: {stone: {type: linear_elastic, young_modulus: 2, poisson_ratio: 0.2}}\n"
        "supports: {pin: {at: [0, 0], fix: xy}, roller: {at: [4, 0], fix: y}}\n"
        "stages: [{loads: [{type: point_load, at: [0, 3], force: [1, 0]}]}]\n");
  }
};

/// The rate of rotation of a point is the skew part of the displacement's gradient, in every node that moves it.
TEST_P(KinematicsContract, RotationsAreThoseOfTheDisplacement) {
  const Structure made = structure();
  const Body& body = made.body();
  constexpr double step = 1e-3;
  for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b) {
    const BlockId block{b};
    const Vec2 x = body.block(block).moments.centroid + Vec2(0.02, -0.03);
    const auto at = [&](const Vec2& place) { return motions_at(body, block, place); };
    const auto rotations = rotations_at(body, block, x);
    ASSERT_EQ(rotations.size(), at(x).size());
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      const auto slope = [&](const Vec2& way) -> Mat26 {
        return (at(x + step * way)[i].rows - at(x - step * way)[i].rows) / (2 * step);
      };
      const Vec6 turn = (slope(Vec2::UnitX()).row(1) - slope(Vec2::UnitY()).row(0)).transpose() / 2;
      EXPECT_EQ(rotations[i].first, at(x)[i].node);
      EXPECT_LT((rotations[i].second - turn).norm(), 1e-9);
    }
  }
}

/// No rigid motion stores anything, and stiffness is symmetric.
TEST_P(KinematicsContract, RigidMotionsStoreNothing) {
  const Structure made = structure();
  const Equilibrium equilibrium = made.equilibrium();
  Mat2 turn;
  turn << 0, -0.3, 0.3, 0;
  std::vector<double> d = made.field({1, 2}, turn);
  d.resize(equilibrium.num_unknowns(), 0.0);
  std::vector<double> forces(d.size(), 0.0);
  equilibrium.intact().multiply_add(d, forces);
  for (const Spring& spring : equilibrium.supports())
    spring.displacement.add_gradient(-spring.stiffness * spring.displacement.value(d, 0), forces);
  std::vector<double> absolute(d.size(), 0.0);
  equilibrium.add_absolute_products(d, absolute);
  const double largest = *std::ranges::max_element(absolute);
  for (const double force : forces) EXPECT_LT(std::abs(force), 1e-12 * largest);
}

INSTANTIATE_TEST_SUITE_P(All, KinematicsContract, testing::ValuesIn(known()));

}  // namespace
}  // namespace dda
