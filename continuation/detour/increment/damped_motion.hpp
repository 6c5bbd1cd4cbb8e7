#pragma once

#include <span>
#include <vector>

#include "continuation/detour/increment/fictitious_mass.hpp"

namespace dda {

/// The motion M d̈ = −R(d) from rest with kinetic damping, by central differences with a time step of one:
///
///     p ← p − R(d),  v = M⁻¹ p,  d ← d + v            from rest p ← −R/2
///
/// The kinetic energy ½ p·v is what the potential energy has fallen by. Where it has a peak the potential has
/// its valley along the motion: there the blocks are stopped, and the motion begins anew. The place on the
/// last step is where R·v vanishes between its values at both ends, exact for a quadratic potential.
class DampedMotion {
 public:
  DampedMotion(const FictitiousMass& mass, std::vector<double> d);

  const std::vector<double>& d() const { return d_; }
  /// Of the step that led to d(); 0 at rest [FL].
  double kinetic_energy() const { return energy_; }
  /// One step under the residual R(d()); true when the blocks were stopped on the last one instead.
  bool move(std::span<const double> residual);

 private:
  void stop(double slope);

  const FictitiousMass& mass_;
  std::vector<double> d_, momentum_, velocity_;
  double energy_ = 0;
  double slope_ = 0;  ///< R·v at the beginning of the last step [FL]
  bool is_at_rest_ = true;
};

}  // namespace dda
