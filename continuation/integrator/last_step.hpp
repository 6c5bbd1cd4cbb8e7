#pragma once

#include "continuation/integrator/integrator.hpp"

namespace dda {

/// Integrators that take the velocity from the last step: v = (y₁ − y₀)/dt, the mean over it.
///
///     c = 1/(dt dt_m),     K₁ − K̂ = −(dt_m/dt) ∇Π(y₁) · (½ (y₁ + ŷ) − y₀)
class LastStep : public Integrator {
 public:
  /// dt_m, over which accelerations act.
  virtual double mean(const Interval& dt) const = 0;

  BodyCourse begin(const Pose& now, const Pose& velocity, double dt) const final {
    const BodyCourse at_rest{now, now, Pose::Zero(), Pose::Zero()};
    return pushed(at_rest, rigid_part(now, velocity), dt);
  }
  BodyCourse pushed(const BodyCourse& at, const RigidMotion& by, double dt) const final {
    BodyCourse out = at;
    out.before =
        pose_of(centre_of(at.before) - dt * by.velocity, rotation(-dt * by.spin) * gradient_of(at.before));
    out.velocity = (out.now - out.before) / dt;
    return out;
  }
  BodyCourse calmed(const BodyCourse& at, double dt) const final {
    BodyCourse out = at;
    out.before = pose_of(centre_of(at.before), rotation(polar_of(gradient_of(at.before)).angle) *
                                                   polar_of(gradient_of(at.now)).stretch);
    out.velocity = (out.now - out.before) / dt;
    return out;
  }
  bool has_mean_velocities() const final { return true; }
  double per_square_time(const Interval& dt) const final { return 1 / (dt.now * mean(dt)); }
  BodyCourse arrive(const BodyStep& step) const final {
    return {step.start.now, step.reached, (step.reached - step.start.now) / step.dt.now,
            per_square_time(step.dt) * (step.reached - step.flight)};
  }
  BodyWork work(const AffineBlock& block, const BodyStep& step) const final {
    const double share = mean(step.dt) / step.dt.now;
    const Pose way = share * ((step.reached + step.flight) / 2 - step.start.now);
    return {way, way, kinetic_energy(block, (step.flight - step.start.now) / step.dt.now), 0};
  }
};

}  // namespace dda
