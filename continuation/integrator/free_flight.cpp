#include <cmath>

#include "continuation/integrator/last_step.hpp"

namespace dda {
namespace {

/// Flies exactly where nothing acts, for any rotation and any step; parabolas are exact at their nodes, contact and
/// strain are implicit.
///
///     ĉ = c + dt w,      F̂ = R(φ + Δφ dt/dt₋) (U + ΔU dt/dt₋)      F = R U,  w and Δ from the last step
///     dt_m = ½ (dt + dt₋), ½ dt at the beginning
class FreeFlight final : public LastStep {
 public:
  explicit FreeFlight(const NoParameters&) {}
  double mean(const Interval& dt) const override { return dt.begins ? dt.now / 2 : (dt.now + dt.before) / 2; }
  Pose flight(const BodyCourse& at, const Interval& dt) const override {
    const double share = dt.now / dt.before;
    const Polar then = polar_of(gradient_of(at.before)), here = polar_of(gradient_of(at.now));
    const double turn = std::remainder(here.angle - then.angle, 2 * M_PI);
    return pose_of(
        centre_of(at.now) + share * (centre_of(at.now) - centre_of(at.before)),
        rotation(here.angle + share * turn) * (here.stretch + share * (here.stretch - then.stretch)));
  }
};

}  // namespace

DDA_REGISTER(
    integrators(), "free_flight",
    Schema<NoParameters>("Exact in free flight, rotations included; implicit in contact and strain, whose "
                         "vibrations it damps."),
    make_of<FreeFlight>);

}  // namespace dda
