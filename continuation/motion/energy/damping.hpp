#pragma once

#include "continuation/bodies/bonds.hpp"
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
/// v is the velocity at the end of the step, s that of the integrator; ∂Φ/∂z = C v. Strains, openings and stretches are
/// damped by rates of their own, with the secants of the joints where the step starts, so that rotations cost nothing but
/// by a. What it spends in the step is (y₁ − y₀)·C (y₁ − y₀)/dt.
class Damping {
 public:
  /// How a step goes, beside where it starts.
  struct Step {
    Poses velocities;     ///< ẏ₀; none where s is 1
    double dt = 1;        ///< [T]
    double end_rate = 1;  ///< s
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
  /// ½ Δ·C Δ, C without its factors of time in the first, and a and b apart.
  double energy(const Measures& now, const Measures& from) const;
  AffineBlock viscous(std::size_t body) const;

  const MovingScene& scene_;
  const std::vector<Bond>& bonds_;
  DampingRates rates_;
  std::vector<Mat2> frames_, secants_;  ///< of the bonds
  Measures start_, origin_;             ///< of y₀ and y*
  double per_time_ = 0;                 ///< s/dt
  double dt_ = 0;
};

}  // namespace dda
