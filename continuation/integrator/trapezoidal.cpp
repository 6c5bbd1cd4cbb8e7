#include "continuation/integrator/integrator.hpp"

namespace dda {
namespace {

/// Newmark's method with the mean of both accelerations: of second order, without damping.
///
///     ŷ = y + dt v + ¼ dt² a,    c = 4/dt²
///     v₁ = 2 (y₁ − y)/dt − v,    a₁ = c (y₁ − ŷ)
///     K₁ − K = ½ dt (a + a₁) · M (v + v₁)/2 = −½ (∇Π + ∇Π₁) · (y₁ − y)
class Trapezoidal final : public Integrator {
 public:
  explicit Trapezoidal(const NoParameters&) {}
  BodyCourse begin(const Pose& now, const Pose& velocity, double dt) const override {
    return {now - dt * velocity, now, velocity, Pose::Zero()};
  }
  double per_square_time(const Interval& dt) const override { return 4 / (dt.now * dt.now); }
  Pose flight(const AffineBlock&, const BodyCourse& at, const Interval& dt) const override {
    return at.now + dt.now * at.velocity + dt.now * dt.now / 4 * at.acceleration;
  }
  double share_of_end() const override { return 0.5; }
  double end_rate() const override { return 2; }
  BodyCourse arrive(const BodyStep& step) const override {
    return {step.start.now, step.reached,
            2 / step.dt.now * (step.reached - step.start.now) - step.start.velocity,
            per_square_time(step.dt) * (step.reached - step.flight)};
  }
  BodyWork work(const AffineBlock& block, const BodyStep& step) const override {
    const Pose way = step.reached - step.start.now;
    return {way / 2, way, kinetic_energy(block, step.start.velocity),
            way.dot(block.times_mass(step.start.acceleration)) / 2};
  }
  BodyCourse pushed(const BodyCourse& at, const RigidMotion& by, double) const override {
    BodyCourse out = at;
    out.velocity += rate_of(at.now, by);
    return out;
  }
};

}  // namespace

DDA_REGISTER(integrators(), "trapezoidal",
             Schema<NoParameters>("Of second order and without damping, for vibrations of what is joined: "
                                  "Newmark's mean acceleration. Bodies that meet ring on their contacts, "
                                  "hop, and slide where they should stick: take `free_flight` for them."),
             make_of<Trapezoidal>);

}  // namespace dda
