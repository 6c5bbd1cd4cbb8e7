#include "continuation/integrator/last_step.hpp"

namespace dda {
namespace {

/// Implicit Euler in all six numbers of a pose: ŷ = y + dt v, dt_m = dt. Of first order; it damps whatever turns.
class ImplicitEuler final : public LastStep {
 public:
  explicit ImplicitEuler(const NoParameters&) {}
  double mean(const Interval& dt) const override { return dt.now; }
  Pose flight(const AffineBlock&, const BodyCourse& at, const Interval& dt) const override {
    return at.now + dt.now / dt.before * (at.now - at.before);
  }
};

}  // namespace

DDA_REGISTER(integrators(), "implicit_euler",
             Schema<NoParameters>("Of first order; damps vibrations and rotations. For comparison."),
             make_of<ImplicitEuler>);

}  // namespace dda
