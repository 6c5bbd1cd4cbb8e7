// What is kept of the points of sides and cuts, where cuts have come or gone, is what would be made.
#include <gtest/gtest.h>

#include <initializer_list>

#include "support/cut_structure.hpp"

namespace dda {
namespace {

void expect_same(const InterfacePoint& a, const InterfacePoint& b) {
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.second, b.second);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.weight, b.weight);
  EXPECT_EQ(a.stiffness, b.stiffness);
  EXPECT_EQ(a.law->initial_kappa(a.stiffness), b.law->initial_kappa(b.stiffness));
  EXPECT_EQ(a.interface, b.interface);
  EXPECT_EQ(a.side, b.side);
  EXPECT_EQ(a.cut, b.cut);
  EXPECT_EQ(a.is_awaited, b.is_awaited);
  EXPECT_EQ(a.rows.first, b.rows.first);
  EXPECT_EQ(a.rows.second, b.rows.second);
  EXPECT_EQ(a.rows.first_stress, b.rows.first_stress);
  EXPECT_EQ(a.rows.second_stress, b.rows.second_stress);
  EXPECT_EQ(a.strength_factor, b.strength_factor);
  ASSERT_EQ(a.gradients.size(), b.gradients.size());
  ASSERT_EQ(a.jumps.size(), b.jumps.size());
  for (std::size_t j = 0; j < a.jumps.size(); ++j) {
    EXPECT_EQ(a.jumps[j].node, b.jumps[j].node);
    EXPECT_EQ(a.jumps[j].rows, b.jumps[j].rows);
  }
}

void expect_made_anew(const Equilibrium& equilibrium, const CutStructure& structure) {
  const Equilibrium fresh = structure.equilibrium();
  ASSERT_EQ(equilibrium.num_points(), fresh.num_points());
  ASSERT_EQ(equilibrium.num_active(), fresh.num_active());
  for (std::size_t p = 0; p < fresh.num_points(); ++p) expect_same(equilibrium.point(p), fresh.point(p));
  ASSERT_EQ(equilibrium.intact().num_stored(), fresh.intact().num_stored());
  for (std::size_t s = 0; s < fresh.intact().num_stored(); ++s)
    EXPECT_EQ(equilibrium.intact().value(s), fresh.intact().value(s));
}

/// A side that a cut has left is whole again; one that is opened leaves the bonds and joins the cuts.
TEST(RemadePoints, AreThoseOfASetThatIsMadeAnew) {
  const std::string field = ", field: {coefficient_of_variation: 0.2, correlation_length: 4, seed: 1}";
  for (const CutStructure::Wish& wish : std::initializer_list<CutStructure::Wish>{
           {}, {.more = "kinematics: second_order\n"}, {.of_joint = field}}) {
    CutStructure structure(wish);
    Equilibrium equilibrium = structure.equilibrium();
    const auto remake = [&] {
      equilibrium.remake(structure.body(), structure.deck());
      expect_made_anew(equilibrium, structure);
    };
    ASSERT_GE(structure.cut_straight({11.3, 0}, {0.07, 1}, 3), 3);
    remake();
    structure.cracks().drop_last();
    structure.cracks().drop_last();
    remake();
    ASSERT_GE(structure.cut_straight({20.2, 10}, {-0.2, -1}, 2), 2);
    remake();
    const Side& side = structure.assembly().sides[40];
    ASSERT_TRUE(structure.cracks().open(40, side.start, side.end, 1));
    remake();
    structure.cracks().drop_last();
    remake();
  }
}

}  // namespace
}  // namespace dda
