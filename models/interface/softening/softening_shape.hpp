#pragma once

#include <memory>
#include <vector>

#include "framework/base/vec2.hpp"

namespace dda {

/// A softening curve without units: traction over strength, g, against ω = w ft/Gf.
///
///     g(0) = 1,  ∫₀^∞ g dω = 1,  g never rises
///
/// Everything a law needs of its curve; units, damage and mixed mode are DamageLaw's.
class SofteningShape {
 public:
  virtual ~SofteningShape() = default;
  virtual double value(double omega) const = 0;
  virtual double slope(double omega) const = 0;
  /// max |dg/dω|.
  virtual double steepest() const = 0;
  /// ω at which the traction has vanished; infinite when it never does.
  virtual double end() const = 0;
  /// Where beyond ω the slope jumps next; infinite when it never does.
  virtual double next_corner(double omega) const = 0;
  /// Share of Gf that is spent for good at ω, unloading to the origin: ∫₀^ω g − ½ ω g.
  virtual double spent(double omega) const = 0;
  /// ω ≥ 0 with scale ω + kappa0 g(ω) = opening; the left side must rise with ω.
  virtual double at_trial_opening(double opening, double scale, double kappa0) const = 0;
  /// ω' with ω'/g(ω') = ratio ω/g(ω): the same compliance of the crack on a curve stretched by 1/ratio.
  virtual double at_same_compliance(double omega, double ratio) const = 0;
};

/// Straight pieces through (ω, g), from (0, 1) down to (end, 0).
std::unique_ptr<SofteningShape> piecewise_linear_shape(std::vector<Vec2> vertices);

/// g = exp(−ω).
std::unique_ptr<SofteningShape> exponential_shape();

}  // namespace dda
