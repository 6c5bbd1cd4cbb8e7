#include "continuation/integrator/last_step.hpp"

namespace dda {
namespace {

/// Implicit Euler in all six numbers of a pose: ŷ = y + dt v, dt_m = dt. Of first order; it damps whatever turns.
class ImplicitEuler final : public LastStep {
 public:
  explicit ImplicitEuler(const NoParameters&) {}
  double mean(const Interval& dt) const override { return dt.now; }
  Pose flight(const AffineBlock& block, const BodyCourse& at, const Interval& dt) const override {
    const double share = dt.now / dt.before;
    const Mat2 before = gradient_of(at.before), now = gradient_of(at.now);
    const double turn = share * std::remainder(polar_of(now).angle - polar_of(before).angle, 2 * M_PI),
                 back = dt.now * mean(dt) * turned_back(block, at.now, turn);
    return pose_of(centre_of(at.now) + share * (centre_of(at.now) - centre_of(at.before)),
                   rotation(back) * (now + share * (now - before)));
  }
};

}  // namespace

DDA_REGISTER(integrators(), "implicit_euler",
             Schema<NoParameters>("Of first order; damps vibrations and rotations. For comparison."),
             make_of<ImplicitEuler>);

}  // namespace dda
