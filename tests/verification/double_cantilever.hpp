#pragma once

#include <cmath>
#include <string>

namespace dda::verification {

/// Two arms, joined by a cohesive ligament, bent apart by pure moments at their free ends.
///
///     G = M²/(b E I),  I = b h³/12        so the crack grows at M = √(Gf b E I), whatever the cohesive law
///
/// The moment is a pair of tractions ±τ on the halves of each arm's end: M = λ τ b h²/4 with τ = 1.
/// Source: J integral of the double cantilever in pure bending, plane stress.
struct DoubleCantilever {
  int rows = 8;                                                  ///< of square blocks through each arm
  double strength = 3;                                           ///< ft [MPa]
  double energy = 0.002;                                         ///< Gf [N/mm]
  double young = 30000;                                          ///< [MPa]
  double arm_height = 10, width = 10, length = 100, crack = 30;  ///< h, b, L, a [mm]
  std::string kinematics = "first_order";

  std::string deck() const;
  double moment() const {
    const double inertia = width * arm_height * arm_height * arm_height / 12;
    return std::sqrt(energy * width * young * inertia);
  }
  /// Mean moment while the dissipated energy grows from 21 % to 64 % of the whole ligament's: the cohesive
  /// zone is developed and far from both ends. Relative to `moment()`.
  double mean_plateau() const;
};

}  // namespace dda::verification
