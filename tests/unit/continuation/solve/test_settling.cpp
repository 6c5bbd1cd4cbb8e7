#include <gtest/gtest.h>

#include <functional>

#include "continuation/solve/settling.hpp"

namespace dda {
namespace {

/// Iterations after which a gap that follows this course is given up; 0 when it never is.
int given_up(
    const std::function<double(int)>& gap,
    const std::function<std::size_t(int)>& pieces = [](int) { return 0; }) {
  const MultiplierParameters parameters;
  Settling settling(parameters);
  for (int i = 0; i < parameters.max_iterations && gap(i) > parameters.tolerance; ++i)
    if (settling.is_out_of_reach(gap(i), pieces(i))) return i + 1;
  return 0;
}

TEST(Settling, AGapThatStagnatesIsGivenUpEarly) {
  EXPECT_EQ(given_up([](int i) { return 1.5e-8 * std::pow(1 - 1e-5, i); }), 41);
  EXPECT_EQ(given_up([](int i) { return 0.1 * std::pow(0.5, i) + 1.5e-8 * std::pow(1 - 1e-5, i); }), 81);
}

TEST(Settling, OneThatComesDownIsNot) {
  EXPECT_EQ(given_up([](int i) { return 0.1 * std::pow(0.9, i); }), 0);
  EXPECT_EQ(given_up([](int i) { return 1e-6 * std::pow(0.995, i); }), 0);
  // It just does not in a thousand iterations.
  EXPECT_GT(given_up([](int i) { return 1e-2 * std::pow(0.99, i); }), 0);
}

TEST(Settling, StretchesInWhichAPieceChangesSayNothing) {
  const auto gap = [](int i) { return i < 150 ? 1e-6 : 1e-6 * std::pow(0.9, i - 150); };
  EXPECT_EQ(given_up(gap), 41);
  EXPECT_EQ(given_up(gap, [](int i) { return static_cast<std::size_t>(i / 15); }), 0);
}

}  // namespace
}  // namespace dda
