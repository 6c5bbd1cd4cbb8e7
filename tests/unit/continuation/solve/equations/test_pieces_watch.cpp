#include <gtest/gtest.h>

#include "continuation/solve/equations/pieces_watch.hpp"

namespace dda {
namespace {

TEST(PiecesWatch, TellsStayingFromReturning) {
  PiecesWatch watch;
  watch.see(7);
  EXPECT_FALSE(watch.stays() || watch.returns());
  watch.see(7);
  EXPECT_TRUE(watch.stays());
  EXPECT_FALSE(watch.returns());
  watch.see(8);
  EXPECT_FALSE(watch.stays() || watch.returns()) << "a new set";
  watch.see(7);
  EXPECT_TRUE(watch.returns());
  EXPECT_FALSE(watch.stays());
}

TEST(PiecesWatch, CountsIterationsThatBringNoNewSet) {
  PiecesWatch watch;
  for (const std::size_t set : {1, 2, 3}) watch.see(set);
  EXPECT_EQ(watch.on_seen_sets(), 0);
  for (const std::size_t set : {3, 1, 4, 1}) watch.see(set);
  EXPECT_EQ(watch.on_seen_sets(), 3);
}

}  // namespace
}  // namespace dda
