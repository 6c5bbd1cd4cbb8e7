#include <gtest/gtest.h>

#include "studies/dda/figures/material_colours.hpp"
#include "studies/dda/figures/model_picture.hpp"

namespace dda {
namespace {

/// Tᵀ F of a force at an offset from the centroid.
Vec6 row_of(const Vec2& offset, const Vec2& force) { return displacement_rows(offset).transpose() * force; }

TEST(ActingForce, StandsWhereItActs) {
  for (const Vec2& force : {Vec2(3, 0), Vec2(0, -2), Vec2(1e-3, 5e-3)}) {
    const ActingForce found = acts_at(row_of({0.7, -0.2}, force));
    EXPECT_NEAR((found.force - force).norm(), 0, 1e-15);
    EXPECT_NEAR((found.offset - Vec2(0.7, -0.2)).norm(), 0, 1e-12);
  }
}

TEST(ActingForce, OfTwoEqualForcesStandsAtTheirMiddle) {
  const ActingForce found = acts_at(row_of({1, 0}, {0, -1}) + row_of({0, 2}, {0, -1}));
  EXPECT_NEAR((found.force - Vec2(0, -2)).norm(), 0, 1e-15);
  EXPECT_NEAR((found.offset - Vec2(0.5, 1)).norm(), 0, 1e-12);
}

TEST(ActingForce, CoupleHasNone) {
  const ActingForce found = acts_at(row_of({1, 0}, {0, 1}) + row_of({-1, 0}, {0, -1}));
  EXPECT_TRUE(found.force.isZero(0));
  EXPECT_TRUE(found.offset.isZero(0));
}

TEST(MaterialColours, RegionsOfOneMaterialShareOne) {
  Assembly assembly;
  assembly.regions = {{"left", "concrete"}, {"plate", "steel"}, {"right", "concrete"}};
  const MaterialColours found = material_colours(assembly);
  EXPECT_EQ(found.names, (std::vector<std::string>{"concrete", "steel"}));
  EXPECT_EQ(found.of_region, (std::vector<int>{0, 1, 0}));
}

}  // namespace
}  // namespace dda
