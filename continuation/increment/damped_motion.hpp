#pragma once

#include <array>
#include <span>
#include <vector>

#include "continuation/increment/fictitious_mass.hpp"

namespace dda {

/// The motion M d̈ = −R(d) from rest with kinetic damping, by central differences with a time step of one:
///
///     p ← p − R(d),  v = M⁻¹ p,  d ← d + v            from rest p ← −R/2
///
/// The kinetic energy ½ p·v is what the potential energy has fallen by. Where it has a peak the potential has
/// its valley along the motion: there the blocks are stopped, and the motion begins anew. The place is that
/// of the peak of a parabola through the last three energies.
class DampedMotion {
 public:
  DampedMotion(const FictitiousMass& mass, std::vector<double> d);

  const std::vector<double>& d() const { return d_; }
  /// Of the step that led to d() [FL].
  double kinetic_energy() const { return energy_[1]; }
  /// One step under the residual R(d()); true when the blocks were stopped on the last one instead.
  bool move(std::span<const double> residual);

 private:
  void stop(double energy);
  double share_to_peak(double energy) const;

  const FictitiousMass& mass_;
  std::vector<double> d_, momentum_, velocity_;
  std::array<double, 2> energy_{0, 0};  ///< of the last two steps [FL]
  int steps_ = 0;                       ///< since the blocks were at rest
};

}  // namespace dda
