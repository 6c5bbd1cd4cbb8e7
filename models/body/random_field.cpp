#include "models/body/random_field.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace dda {
namespace {

constexpr int num_waves = 256;

/// In (0, 1): the standard fixes the generator's bits but not those of its distributions.
double uniform(std::mt19937_64& bits) { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1.0p-53; }

/// Two independent standard normal numbers (Box and Muller).
Vec2 normal_pair(std::mt19937_64& bits) {
  const double radius = std::sqrt(-2 * std::log(uniform(bits)));
  const double angle = 2 * std::numbers::pi * uniform(bits);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace

Schema<FieldParameters> field_schema() {
  using P = FieldParameters;
  return Schema<P>("A random field by which strengths and fracture energies vary in space.")
      .number("coefficient_of_variation", &P::coefficient_of_variation,
              {.bounds = at_least(0) & at_most(1),
               .text = "Standard deviation of the strength over its mean; 0 = uniform."})
      .number("correlation_length", &P::correlation_length,
              {.dimension = dimension::length,
               .bounds = above(0),
               .text = "ℓ of the correlation exp(−(r/ℓ)²) of two places a distance r apart."})
      .number("energy_exponent", &P::energy_exponent,
              {.fallback = 2.0,
               .bounds = at_least(0) & at_most(4),
               .text = "Where the strength is f times its mean, fracture energies are f to this power: 2 "
                       "keeps l_ch, 1 the ultimate opening, 0 the energy."})
      .integer("seed", &P::seed,
               {.fallback = 1,
                .bounds = at_least(0),
                .text = "Selects the realisation; interfaces of one seed and length vary together."});
}

RandomField::RandomField(const FieldParameters& p)
    : deviation_(std::sqrt(std::log1p(p.coefficient_of_variation * p.coefficient_of_variation))) {
  std::mt19937_64 bits(static_cast<std::uint64_t>(p.seed));
  for (int j = 0; j < num_waves; ++j) {
    const Vec2 frequency = std::numbers::sqrt2 / p.correlation_length * normal_pair(bits);
    waves_.push_back({frequency, 2 * std::numbers::pi * uniform(bits)});
  }
}

double RandomField::normal(const Vec2& x) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += std::cos(wave.frequency.dot(x) + wave.phase);
  return std::sqrt(2.0 / num_waves) * sum;
}

double RandomField::factor(const Vec2& x) const {
  return std::exp(deviation_ * (normal(x) - 0.5 * deviation_));
}

}  // namespace dda
