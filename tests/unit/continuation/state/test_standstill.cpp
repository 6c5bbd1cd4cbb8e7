#include <gmock/gmock.h>

#include <cmath>

#include "continuation/state/standstill.hpp"
#include "framework/files/run/record.hpp"

namespace dda {
namespace {

Station station(double moved, double load_factor, bool is_rescue = false) {
  return {.movements = {moved, 0}, .load_factor = load_factor, .dissipated = 0, .is_rescue = is_rescue};
}

/// Steps until a path is said to stand still; −1 if it never is.
template <class Step>
int steps_until_still(Step step) {
  Standstill standstill(100);
  for (int i = 0; i < 1000; ++i)
    if (!standstill.add(step(i)).empty()) return i;
  return -1;
}

TEST(Standstill, IsSeenAfterAFewStepsThatChangeNothing) {
  EXPECT_EQ(steps_until_still([](int) { return station(1, 2); }), 8);
  EXPECT_EQ(steps_until_still([](int) { return station(0, 0); }), 8) << "nothing has moved at all";
  EXPECT_EQ(steps_until_still([](int i) { return station(1e-15 * std::sin(i), 1e-17 * i); }), 8)
      << "a load factor that is rounding moves nothing";
}

TEST(Standstill, IsSeenWhereTheStateComesBackAndForth) {
  EXPECT_EQ(steps_until_still([](int i) { return station(1, 1 + 1e-12 * (i % 2)); }), 8);
}

/// A path that swings between 0.5 and 1.5.
Station swinging(int i, int period, double growth, int leg) {
  Station out = station(1 + 0.5 * std::cos(2 * M_PI * i / period) + growth * i, 1);
  out.leg = leg;
  return out;
}

TEST(Standstill, RoundsOfAnyLengthAreSeen) {
  for (const int period : {2, 3, 7, 37}) {
    const int seen = steps_until_still([&](int i) { return swinging(i, period, 0, 0); });
    EXPECT_GT(seen, 5 * period) << period;
    EXPECT_LT(seen, 25 * period) << period;
  }
}

TEST(Standstill, RoundsThatGrowAndLegsOfAProgrammeAreProgress) {
  EXPECT_EQ(steps_until_still([](int i) { return swinging(i, 7, 1e-3, 0); }), -1);
  EXPECT_EQ(steps_until_still([](int i) { return swinging(i, 7, 0, i / 7); }), -1) << "a cyclic test";
}

/// A run that is killed and resumed ends where it would have.
TEST(Standstill, IsStoredWithThePath) {
  Standstill whole(100), resumed(100);
  std::string told;
  int steps = 0;
  for (; told.empty(); ++steps) told = whole.add(swinging(steps, 7, 0, 0));
  for (int i = 0; i < steps; ++i) {
    EXPECT_EQ(resumed.add(swinging(i, 7, 0, 0)), i + 1 < steps ? "" : told);
    RestartData data;
    put(data, "path", resumed);
    resumed = take<Standstill>(data, "path");
  }
}

TEST(Standstill, CreepIsSeenLater) {
  const int seen = steps_until_still([](int i) { return station(1 + 1e-9 * i, 1); });
  EXPECT_GT(seen, 8);
  EXPECT_LT(seen, 100);
}

TEST(Standstill, PointsThatAreAddedAreProgress) {
  const auto with_points = [](int i) {
    Station out = station(1, 1);
    out.movements.resize(static_cast<std::size_t>(2 + i / 5), 0.0);
    return out;
  };
  EXPECT_EQ(steps_until_still(with_points), -1);
}

TEST(Standstill, RescuesMayChangeLess) {
  const auto creeps = [](bool is_rescue) {
    return steps_until_still([&](int i) { return station(1 + 2e-6 * i, 1, is_rescue); });
  };
  EXPECT_EQ(creeps(false), -1);
  EXPECT_GT(creeps(true), 8);
}

TEST(Standstill, AnyQuantityThatChangesIsProgress) {
  EXPECT_EQ(steps_until_still([](int i) { return station(1, 1 + 0.001 * i); }), -1);
  EXPECT_EQ(steps_until_still([](int i) { return station(1 + 0.001 * i, 1); }), -1);
  EXPECT_EQ(steps_until_still([](int i) {
              Station out = station(1, 1);
              out.dissipated = 1 + 0.001 * i;
              return out;
            }),
            -1);
}

}  // namespace
}  // namespace dda
