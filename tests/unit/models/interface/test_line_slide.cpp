// Friction along the straight line of a step, against many small steps along it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "models/interface/coulomb.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

/// Energy by small steps: e at the limit of the pressure, times what slides; nothing while apart.
double summed(const Vec2& from, const Vec2& to, double slip, double m, int steps) {
  double s = slip, sum = 0, before = 0;
  for (int i = 0; i <= steps; ++i) {
    const Vec2 q = from + static_cast<double>(i) / steps * (to - from);
    if (q.x() > 0) {
      before = 0;
      continue;
    }
    const double limit = -m * q.x(), e = std::clamp(q.y() - s, -limit, limit);
    const double slid = q.y() - e - s;
    if (i > 0) sum += 0.5 * (before + std::abs(e)) * std::abs(slid);
    s += slid;
    before = std::abs(e);
  }
  return sum;
}

/// A start that its own friction holds, and an end anywhere, closed or apart.
struct Line {
  Vec2 from, to;
  double slip, m;
};
Line random_line(Random& random) {
  Line out;
  out.m = random.between(0.05, 1.5);
  out.from = {-random.between(0, 1), random.between(-1, 1)};
  out.slip = out.from.y() + random.between(-1, 1) * out.m * out.from.x();
  out.to = out.from + random.point(2);
  return out;
}

TEST(LineSlide, IsTheSumOfSmallSteps) {
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const Line at = random_line(random);
    const double sum = summed(at.from, at.to, at.slip, at.m, 100000);
    EXPECT_NEAR(slide_along(at.from, at.to, at.slip, at.m).energy, sum, 2e-4 * std::max(sum, 0.01)) << i;
  }
}

TEST(LineSlide, GradientIsTheDifference) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Line at = random_line(random);
    const LineSlide here = slide_along(at.from, at.to, at.slip, at.m);
    if (here.energy < 1e-4) continue;
    for (int c = 0; c < 2; ++c) {
      const Vec2 step = 1e-6 * Vec2::Unit(c);
      const LineSlide more = slide_along(at.from, at.to + step, at.slip, at.m),
                      less = slide_along(at.from, at.to - step, at.slip, at.m);
      EXPECT_NEAR(here.gradient[c], (more.energy - less.energy) / 2e-6, 1e-6) << i;
      EXPECT_NEAR(here.mean_gradient[c], (more.mean - less.mean) / 2e-6, 1e-6) << i;
    }
  }
}

TEST(LineSlide, IsHalfOfTheEndFromNoLoad) {
  const LineSlide found = slide_along({0, 0}, {-1, 2}, 0, 0.5);
  EXPECT_DOUBLE_EQ(found.energy, 0.5 * 0.5 * 1.5);
  EXPECT_DOUBLE_EQ(found.mean, 0.25);
}

TEST(LineSlide, OfStickingIsNothing) {
  EXPECT_EQ(slide_along({-1, 0}, {-1, 0.4}, 0, 0.5).energy, 0);
  EXPECT_EQ(slide_along({0.1, 0}, {0.2, 3}, 0, 0.5).energy, 0) << "apart";
  EXPECT_EQ(slide_along({-1, 0}, {-1, 4}, 0, 0).energy, 0) << "without friction";
}

}  // namespace
}  // namespace dda
