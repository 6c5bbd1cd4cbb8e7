#include <cmath>

#include "models/time_function/time_function.hpp"

namespace dda {
namespace {

struct HarmonicParameters {
  double amplitude = 0, frequency = 0;
};

/// u = a sin(2π f t).
class Harmonic final : public TimeFunction {
 public:
  explicit Harmonic(const HarmonicParameters& p) : p_(p) {}
  double at(double time) const override { return p_.amplitude * std::sin(2 * M_PI * p_.frequency * time); }

 private:
  HarmonicParameters p_;
};

Schema<HarmonicParameters> schema() {
  using P = HarmonicParameters;
  return Schema<P>("A sine, a sin(2π f t).")
      .number("amplitude", &P::amplitude, {.dimension = dimension::length, .text = "Amplitude a."})
      .number("frequency", &P::frequency, {.bounds = above(0), .text = "Frequency f [1/s]."});
}

}  // namespace

DDA_REGISTER(time_functions(), "harmonic", schema(), make_of<Harmonic>);

}  // namespace dda
