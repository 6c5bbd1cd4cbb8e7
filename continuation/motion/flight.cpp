#include "continuation/motion/flight.hpp"

#include <cmath>

namespace dda {

Pose free_flight(const Pose& before, const Pose& now, const Interval& dt) {
  const double share = dt.now / dt.before;
  const Polar then = polar_of(gradient_of(before)), here = polar_of(gradient_of(now));
  const double turn = std::remainder(here.angle - then.angle, 2 * M_PI);
  return pose_of(
      centre_of(now) + share * (centre_of(now) - centre_of(before)),
      rotation(here.angle + share * turn) * (here.stretch + share * (here.stretch - then.stretch)));
}

}  // namespace dda
