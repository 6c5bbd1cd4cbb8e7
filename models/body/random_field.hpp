#pragma once

#include <cstdint>
#include <vector>

#include "framework/base/vec2.hpp"
#include "framework/deck/kind.hpp"
#include "framework/deck/schema.hpp"

namespace dda {

/// How the strength of an interface varies in space.
struct FieldParameters {
  double coefficient_of_variation = 0;
  double correlation_length = 0;
  double energy_exponent = 2;
  std::int64_t seed = 1;
};

Schema<FieldParameters> field_schema();

/// A positive random field of mean 1 in the plane.
///
///     g(x) = √(2/N) Σ cos(ω_j·x + φ_j),   ω_j normal with variance 2/ℓ² per component, φ_j uniform
///     f(x) = exp(s g(x) − s²/2),          s² = ln(1 + V²)
///
/// g has mean 0, variance 1 and the correlation exp(−(r/ℓ)²) over the seeds, whatever N; with N = 256 it is
/// normal but for a kurtosis of 3 − 3/(2N). So f is lognormal with mean 1, coefficient of variation V and
/// correlation (exp(s² exp(−(r/ℓ)²)) − 1)/(exp(s²) − 1). It is a function of place alone: neither the blocks
/// nor their order enter. Spectral representation with random frequencies.
class RandomField {
 public:
  explicit RandomField(const FieldParameters& parameters);

  double normal(const Vec2& x) const;  ///< g
  double factor(const Vec2& x) const;  ///< f

 private:
  struct Wave {
    Vec2 frequency;  ///< ω [1/L]
    double phase;    ///< φ
  };
  std::vector<Wave> waves_;
  double deviation_;  ///< s
};

}  // namespace dda
