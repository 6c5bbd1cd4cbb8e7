#pragma once

#include "continuation/bodies/bonds.hpp"
#include "continuation/integrator/integrator.hpp"
#include "continuation/motion/energy/curvatures.hpp"

namespace dda {

/// Rayleigh's damping C = a M + b K, K the stiffness of strains, joints and springs.
struct DampingRates {
  double mass = 0;       ///< a [1/T]
  double stiffness = 0;  ///< b [T]

  bool is_any() const { return mass > 0 || stiffness > 0; }
};

/// What damping adds to the potential of a step:
///
///     Φ(z) = (dt/2s) v·C v,     v = s (z − y*)/dt,     y* = y₀ + (s − 1)/s dt ẏ₀
///
/// s is that of the integrator, for b K that of the velocity at the end of the step, for a M the one with which a flight slows
/// down as it does; ∂Φ/∂z = C v. Strains, openings and stretches are damped by rates of their own, with the secants of the
/// joints where the step starts, so that rotations cost nothing but by a. What b K spends in the step is
/// (y₁ − y₀)·b K (y₁ − y₀)/dt, and a M that of the mean velocity ½ (ẏ₀ + ẏ₁), for the time between the two.
class Damping {
 public:
  /// How a step goes, beside where it starts.
  struct Step {
    Poses velocities;     ///< ẏ₀; none: it is not needed
    double dt = 1;        ///< [T]
    double end_rate = 1;  ///< s
    DampedFlight flight = {.rate = 1, .span = 1};
  };

  Damping(const MovingScene& scene, const std::vector<Bond>& bonds, const DampingRates& rates)
      : scene_(scene), bonds_(bonds), rates_(rates) {}

  /// `frames` are those of the bonds.
  void begin(const Poses& start, const std::vector<Mat2>& frames, const Step& step);

  /// b s/dt: what damping bears over what stiffness does for the same change.
  double per_stiffness() const { return rates_.stiffness * per_time_; }

  double value(const Poses& z) const;
  void add_forces(const Poses& z, Eigen::VectorXd& out) const;
  void add_curvature(const Poses& z, Curvatures& out) const;
  /// [F L].
  double spent(const Poses& reached) const;

 private:
  struct OpeningAndStress {
    Vec2 opening, stress;
  };
  /// What is damped, at some poses.
  struct Measures {
    Poses poses;
    std::vector<Vec3> strains;             ///< by body
    std::vector<OpeningAndStress> joints;  ///< by bond
    std::vector<double> stretches;         ///< by spring
  };
  Measures measures(const Poses& at) const;
  /// ½ Δ·M Δ and ½ Δ·K Δ.
  double of_mass(const Poses& now, const Poses& from) const;
  double of_stiffness(const Measures& now, const Measures& from) const;
  AffineBlock viscous(std::size_t body) const;
  /// s/dt of what a M damps.
  double per_flight_time() const { return step_.flight.rate / step_.dt; }

  const MovingScene& scene_;
  const std::vector<Bond>& bonds_;
  DampingRates rates_;
  std::vector<Mat2> frames_, secants_;  ///< of the bonds
  Measures start_, origin_;             ///< of y₀ and y*
  Poses mean_from_;                     ///< what y₁ is past by half of ẏ₀ and ẏ₁, times dt
  double per_time_ = 0;                 ///< s/dt
  Step step_;
};

}  // namespace dda
