#include <gtest/gtest.h>

#include "framework/base/disjoint_sets.hpp"

namespace dda {
namespace {

TEST(DisjointSets, AreRepresentedByTheirLowest) {
  DisjointSets sets(6);
  sets.merge(4, 2);
  sets.merge(5, 4);
  sets.merge(1, 1);
  for (const std::size_t i : {2u, 4u, 5u}) EXPECT_EQ(sets.representative(i), 2u);
  for (const std::size_t i : {0u, 1u, 3u}) EXPECT_EQ(sets.representative(i), i);
  sets.merge(5, 0);
  EXPECT_EQ(sets.representative(4), 0u);
}

TEST(DisjointSets, OrByTheOneThatIsToStay) {
  DisjointSets sets(4);
  sets.merge_into(3, 1);
  sets.merge_into(1, 0);
  for (const std::size_t i : {0u, 1u, 3u}) EXPECT_EQ(sets.representative(i), 3u);
  EXPECT_EQ(sets.representative(2), 2u);
}

}  // namespace
}  // namespace dda
