#include "continuation/integrator/integrator.hpp"

namespace dda {
namespace {

/// No inertia: every step goes from rest to the minimum of ½ |y − y₀|²_M/dt² + Π, down to where friction and contact
/// hold everything. What the resistance of the steps spends is booked as numerical.
class Settle final : public Integrator {
 public:
  explicit Settle(const NoParameters&) {}
  BodyCourse begin(const Pose& now, const Pose&, double) const override {
    return {now, now, Pose::Zero(), Pose::Zero()};
  }
  double per_square_time(const Interval& dt) const override { return 1 / (dt.now * dt.now); }
  Pose flight(const AffineBlock&, const BodyCourse& at, const Interval&) const override { return at.now; }
  BodyCourse arrive(const BodyStep& step) const override {
    return {step.start.now, step.reached, Pose::Zero(), Pose::Zero()};
  }
  BodyWork work(const AffineBlock& block, const BodyStep& step) const override {
    const Pose way = step.reached - step.start.now;
    return {way, way, 0, -per_square_time(step.dt) * way.dot(block.times_mass(way))};
  }
  BodyCourse pushed(const BodyCourse& at, const RigidMotion&, double) const override { return at; }
  bool has_inertia() const override { return false; }
};

}  // namespace

DDA_REGISTER(integrators(), "settle",
             Schema<NoParameters>("Without inertia: down to rest under friction, a static answer for masonry "
                                  "and rubble; its times mean nothing."),
             make_of<Settle>);

}  // namespace dda
