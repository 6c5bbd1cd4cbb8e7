#pragma once

#include <limits>
#include <memory>

#include "framework/deck/family.hpp"

namespace dda {

/// A displacement over time, in motion: u(0) = 0.
class TimeFunction {
 public:
  virtual ~TimeFunction() = default;
  /// u(t), t ≥ 0 [L].
  virtual double at(double time) const = 0;
  /// The next time at which the velocity jumps; infinite where it never does again [T].
  virtual double next_kink(double /*after*/) const { return std::numeric_limits<double>::infinity(); }
};

using TimeFunctionFamily = Family<TimeFunction>;
using TimeFunctionChoice = Choice<TimeFunction>;

/// The registry of time functions.
TimeFunctionFamily& time_functions();

}  // namespace dda
