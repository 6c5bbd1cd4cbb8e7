#pragma once

#include <algorithm>
#include <cmath>

#include "continuation/integrator/integrator.hpp"

namespace dda {

/// What two accelerations that follow each other have in common, less what they differ by, at most so much: of what flies,
/// rests or slides all of it, of impacts and vibrations nothing.
inline double common(double before, double now, double most) {
  if (before * now <= 0) return 0;
  const auto [low, high] = std::minmax({std::abs(before), std::abs(now)});
  return std::copysign(std::clamp(2 * low - high, 0.0, most), now);
}

/// What is left, as a torque, of strain forces whose directions at the start of a step count, where a minimum has those
/// at its end: with the turn Δ, G = ∂V/∂F and J = ∫ X Xᵀ dm,
///
///     (R(Δ) − 1) G · ∂F/∂φ = sin Δ  G : F        about the moment of inertia  F J : F   (of the flat body)
///
/// [1/T²]. G : F is what the forces on a body do by pressing or pulling it: bodies that rock under pressure are given energy
/// by the other direction, Δ² G : F a step, those that swing are robbed of it. It is what SHAKE has: the forces of a
/// constraint act along its gradient at the start.
inline double turned_back(const AffineBlock& block, const Pose& now, double turn) {
  const Mat2 f = gradient_of(now), forces = gradient_of(strain_forces(block, now));
  return std::sin(turn) * forces.cwiseProduct(f).sum() / (f * block.inertia).cwiseProduct(f).sum();
}

/// Integrators that take the velocity from the last step: v = (y₁ − y₀)/dt, the mean over it.
///
///     c = 1/(dt dt_m),     K₁ − K̂ = −(dt_m/dt) ∇Π(y₁) · (½ (y₁ + ŷ) − y₀)
///
/// Energies are those of its middle, ½ (y₀ + y₁) − ⅛ dt² a; where bodies are joined that is so of what they do as one, and
/// what vibrates within goes with the energies of the end, as of any implicit step.
class LastStep : public Integrator {
 public:
  /// dt_m, over which accelerations act.
  virtual double mean(const Interval& dt) const = 0;
  /// a, as far as it is there all through a step.
  virtual Vec2 curvature(const BodyStep& /*step*/) const { return Vec2::Zero(); }
  /// The acceleration that lasts beyond a step that has come to this one.
  virtual RigidMotion lasting(const BodyStep& /*step*/, const Pose& /*acceleration*/) const { return {}; }

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
  BodyCourse calmed(const AffineBlock& block, const BodyCourse& at, double dt) const final {
    BodyCourse out = at;
    const double spin =
        rigid_motion_of(block, at.now, at.velocity).spin;  // that of the chord of a turn is sin(Δ)/dt
    out.before = pose_of(centre_of(at.before),
                         rotation(-std::asin(std::clamp(dt * spin, -1.0, 1.0))) * gradient_of(at.now));
    out.velocity = (out.now - out.before) / dt;
    return out;
  }
  bool has_mean_velocities() const final { return true; }
  /// As the means over steps of a flight go, v̈ + a v̇ = 0, from one to the next by exp(−a dt), whatever a dt: with x = a dt and
  /// φ = (1 − e⁻ˣ)/x, the mean of e⁻ᵃᵗ over the step,
  ///
  ///     s = 1/(x φ) − 1/x,     from a velocity that is no mean, at the beginning, 1/(1 − φ) − 2/x
  DampedFlight damped_flight(double a, const Interval& dt) const final {
    constexpr double little = 1e-3;  // below which differences are rounding
    const double x = a * dt.now, span = mean(dt);
    if (span < dt.now) return {x < little ? 2.0 / 3 + x / 18 : 1 / (1 + std::expm1(-x) / x) - 2 / x, span};
    return {x < little ? 0.5 + x / 12 : -1 / std::expm1(-x) - 1 / x, span};
  }
  double per_square_time(const Interval& dt) const final { return 1 / (dt.now * mean(dt)); }
  BodyCourse arrive(const BodyStep& step) const final {
    const Pose acceleration = per_square_time(step.dt) * (step.reached - step.flight);
    return {.before = step.start.now,
            .now = step.reached,
            .velocity = (step.reached - step.start.now) / step.dt.now,
            .acceleration = acceleration,
            .steady = lasting(step, acceleration),
            .lag = lag(step)};
  }
  BodyWork work(const AffineBlock& block, const BodyStep& step) const final {
    const double share = mean(step.dt) / step.dt.now;
    const Pose way = share * ((step.reached + step.flight) / 2 - step.start.now);
    return {way, rubbed(step, way), kinetic_energy(block, (step.flight - step.start.now) / step.dt.now), 0};
  }

 private:
  /// From middle to middle by what lasts of the forces, which has slowed the body in what the last step was longer.
  static Pose rubbed(const BodyStep& step, Pose way) {
    const Pose before = step.start.now - step.start.before, flown = step.flight - step.start.now;
    way.head<2>() += step.lasts / 2 * (before - flown).head<2>();
    return way;
  }
  Pose lag(const BodyStep& step) const {
    Pose out = Pose::Zero();
    if (step.is_joined)
      out.head<2>() = step.as_one.way / 2;
    else
      out = (step.reached - step.start.now) / 2;
    out.head<2>() += step.dt.now * step.dt.now / 8 * curvature(step);
    return out;
  }
};

}  // namespace dda
