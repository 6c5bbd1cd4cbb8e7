#pragma once

#include <algorithm>
#include <cmath>

#include "continuation/integrator/integrator.hpp"

namespace dda {

/// What two reactions that follow each other have in common, at most so much: of what flies, rests or slides all of it.
inline double common(double before, double now, double most) {
  if (before * now <= 0) return 0;
  return std::clamp(std::abs(before) < std::abs(now) ? before : now, -most, most);
}
/// The acceleration of a body by its loads and by what of the reactions to them lasts, which are no more than twice as large:
/// not that of stiff vibrations and of impacts, which a step that is implicit in them has used up by its end.
inline RigidMotion lasting(const BodyStep& step, const Pose& acceleration) {
  if (step.is_joined) return {};
  const double most = 2 * step.pull.norm();
  const RigidMotion before = rigid_part(step.start.now, step.start.acceleration),
                    now = rigid_part(step.reached, acceleration);
  const Vec2 one = before.velocity - step.pull, other = now.velocity - step.pull;
  return {step.pull + Vec2(common(one.x(), other.x(), most), common(one.y(), other.y(), most)),
          common(before.spin, now.spin, most / step.gyration)};
}

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
    const Pose acceleration = per_square_time(step.dt) * (step.reached - step.flight);
    return {.before = step.start.now,
            .now = step.reached,
            .velocity = (step.reached - step.start.now) / step.dt.now,
            .acceleration = acceleration,
            .steady = lasting(step, acceleration)};
  }
  BodyWork work(const AffineBlock& block, const BodyStep& step) const override {
    const double share = mean(step.dt) / step.dt.now;
    const Pose way = share * ((step.reached + step.flight) / 2 - step.start.now);
    return {way, way, kinetic_energy(block, (step.flight - step.start.now) / step.dt.now), 0};
  }
};

}  // namespace dda
