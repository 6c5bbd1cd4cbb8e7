#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda {

/// Numbers that look random and are the same in every run and with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high) {
    constexpr double steps = 9007199254740992.0;  // 2^53
    return low + (high - low) * static_cast<double>(engine_() >> 11) / steps;
  }
  bool coin() { return engine_() >> 63 != 0; }
  /// A point of the square of half-width `scale` about the origin.
  Vec2 point(double scale) {
    const double x = between(-scale, scale);
    return {x, between(-scale, scale)};
  }
  std::vector<double> vector(std::size_t n, double scale) {
    std::vector<double> out(n);
    for (double& value : out) value = between(-scale, scale);
    return out;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace dda
