#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "models/body/random_field.hpp"

namespace dda {
namespace {

constexpr int num_seeds = 4000;

FieldParameters parameters(double variation, double length, int seed) {
  return {.coefficient_of_variation = variation,
          .correlation_length = length,
          .energy_exponent = 2,
          .seed = seed};
}

/// Mean over the seeds of a function of the realisation.
template <class Function>
double mean_over_seeds(double variation, double length, Function function) {
  double sum = 0;
  for (int seed = 0; seed < num_seeds; ++seed)
    sum += function(RandomField(parameters(variation, length, seed)));
  return sum / num_seeds;
}

/// Four standard errors of a mean whose summands have this standard deviation.
double four_errors(double deviation) { return 4 * deviation / std::sqrt(num_seeds); }

TEST(RandomField, IsNormalAtAPlace) {
  const Vec2 x(37, -12);
  std::array<double, 5> moment{};
  for (std::size_t order = 1; order < moment.size(); ++order)
    moment[order] = mean_over_seeds(0.1, 20, [&](const RandomField& field) {
      return std::pow(field.normal(x), static_cast<double>(order));
    });
  EXPECT_NEAR(moment[1], 0, four_errors(1));
  EXPECT_NEAR(moment[2], 1, four_errors(std::sqrt(2.0)));
  EXPECT_NEAR(moment[3], 0, four_errors(std::sqrt(15.0)));
  EXPECT_NEAR(moment[4], 3, four_errors(std::sqrt(96.0)));
}

TEST(RandomField, FactorHasMeanOneAndItsVariation) {
  for (const double variation : {0.1, 0.3}) {
    const Vec2 x(5, 80);
    const double mean =
        mean_over_seeds(variation, 20, [&](const RandomField& field) { return field.factor(x); });
    const double square = mean_over_seeds(
        variation, 20, [&](const RandomField& field) { return std::pow(field.factor(x) - 1, 2); });
    EXPECT_NEAR(mean, 1, four_errors(variation));
    // The fourth moment of the lognormal: sqrt(κ − 1) < 3.4 at V = 0.3.
    EXPECT_NEAR(square, variation * variation, four_errors(3.4 * variation * variation));
  }
}

TEST(RandomField, CorrelationFallsWithDistanceInEveryDirection) {
  const double length = 20;
  for (const double distance : {0.25, 0.5, 1.0, 2.0})
    for (const double angle : {0.0, 0.8, 1.6}) {
      const Vec2 x(3, 4), y = x + distance * length * Vec2(std::cos(angle), std::sin(angle));
      const double found = mean_over_seeds(
          0.1, length, [&](const RandomField& field) { return field.normal(x) * field.normal(y); });
      const double expected = std::exp(-distance * distance);
      EXPECT_NEAR(found, expected, four_errors(std::sqrt(1 + expected * expected)))
          << distance << " lengths at " << angle;
    }
}

TEST(RandomField, ScalesWithItsLength) {
  const RandomField fine(parameters(0.2, 5, 7)), coarse(parameters(0.2, 50, 7));
  for (const double s : {-3.0, 0.0, 0.7, 11.0})
    EXPECT_NEAR(fine.normal(s * Vec2(1, 2)), coarse.normal(10 * s * Vec2(1, 2)), 1e-10);
}

TEST(RandomField, IsPositiveAndFixedByItsSeed) {
  const RandomField field(parameters(1, 20, 3)), same(parameters(1, 20, 3)), other(parameters(1, 20, 4));
  double difference = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec2 x(0.7 * i, 100 - 0.4 * i);
    EXPECT_GT(field.factor(x), 0);
    EXPECT_EQ(field.factor(x), same.factor(x));
    difference = std::max(difference, std::abs(field.normal(x) - other.normal(x)));
  }
  EXPECT_GT(difference, 1);
}

}  // namespace
}  // namespace dda
