// Single bodies and stacks of stone on a ground.
#pragma once

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>

#include "continuation/motion/motion.hpp"
#include "meshing/contact/outline.hpp"

namespace dda {

inline constexpr double young = 1e10, density = 2500, gravity = 9.81, offset = 1e-3;

/// A displacement u = v t.
class Steady final : public TimeFunction {
 public:
  explicit Steady(double speed) : speed_(speed) {}
  double at(double time) const override { return speed_ * time; }

 private:
  double speed_;
};

/// A displacement that begins at rest with an acceleration, and swings.
class Swing final : public TimeFunction {
 public:
  Swing(double acceleration, double frequency) : acceleration_(acceleration), omega_(2 * M_PI * frequency) {}
  double at(double time) const override {
    return acceleration_ * (1 - std::cos(omega_ * time)) / (omega_ * omega_);
  }

 private:
  double acceleration_, omega_;
};

inline MovingBody body(const Polygon& outline, bool is_held = false) {
  const Moments of = moments(outline);
  MovingBody out;
  out.centroid = of.centroid;
  out.block.mass = density * of.area;
  out.block.inertia = density * of.second;
  out.block.volume = of.area;
  constexpr double nu = 0.2;
  out.block.stiffness << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  out.block.stiffness *= young / (1 - nu * nu);
  for (const Vec2& x : core_of(outline, offset).vertices) out.core.push_back(x - of.centroid);
  for (const Vec2& x : outline.vertices) out.outline.push_back(x - of.centroid);
  out.size = std::sqrt(of.area);
  out.modulus = young;
  out.is_held = is_held;
  return out;
}

inline Polygon box(double left, double low, double right, double high) {
  return {{{left, low}, {right, low}, {right, high}, {left, high}}};
}

inline MovingScene scene(double friction, std::vector<MovingBody> bodies, const Vec2& pull) {
  MovingScene out;
  out.meeting.law = contact_laws().choose(parse_yaml("wall", "test")).make();
  out.meeting.reach = 2 * offset;
  out.meeting.friction = [friction](std::size_t, std::size_t) { return friction; };
  out.bodies = std::move(bodies);
  out.gravity = pull;
  return out;
}

inline Poses undeformed(const MovingScene& scene) {
  Poses out;
  for (const MovingBody& body : scene.bodies) out.push_back(body.undeformed());
  return out;
}

inline Poses at_rest(const MovingScene& scene) { return Poses(scene.num_bodies(), Pose::Zero()); }

inline Vec2 inclined(double degrees) {
  return {gravity * std::sin(degrees * M_PI / 180), -gravity * std::cos(degrees * M_PI / 180)};
}

inline void run(Motion& motion) {
  while (motion.advance()) {
  }
  EXPECT_NE(motion.ending(), Motion::Ending::failed) << motion.reason();
}

/// What the energies of a motion miss, over what the loads have done or what moved at first.
inline double unbalanced(const Motion& motion, double scale) {
  return std::abs(motion.ledger().error) / scale;
}

inline std::shared_ptr<const Integrator> integrator(const std::string& name) {
  return integrators().choose(parse_yaml(name, "test")).make();
}

}  // namespace dda
