#include "studies/dda/case/crack_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dda {
namespace {

/// l_ch / h of a point's law; 0 of one that releases at once.
double relative_length(const InterfacePoint& point) {
  if (point.law->releases_at_once()) return 0;
  constexpr double far = 1e6;  // in units of the opening at the strength
  const double k = point.stiffness, at_strength = point.law->initial_kappa(k);
  const double wide_open = std::min(2 * point.law->rupture_kappa(k), far * at_strength);
  const double strength = point.intact_stiffness().x() * at_strength;
  const double energy = point.law->accept({wide_open, 0}, {}, k).dissipated;
  return point.spring_unit * energy / (strength * strength);
}

}  // namespace

double points_of_one_crack(const Equilibrium& equilibrium) {
  return static_cast<double>(equilibrium.interfaces().num_crackable()) /
         std::sqrt(static_cast<double>(equilibrium.num_blocks()));
}

double likely_cracks(const Equilibrium& equilibrium) {
  double points = 0, lengths = 0;
  for (const InterfacePoint& point : equilibrium.interfaces().points) {
    if (!point.law->can_crack()) continue;
    ++points;
    lengths += relative_length(point);
  }
  if (points == 0) return 0;
  constexpr double process_zone = std::numbers::pi / 8;
  return points_of_one_crack(equilibrium) * (1 + process_zone * lengths / points / 2);
}

}  // namespace dda
