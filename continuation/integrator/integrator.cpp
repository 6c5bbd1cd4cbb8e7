#include "continuation/integrator/integrator.hpp"

namespace dda {

IntegratorFamily& integrators() {
  static IntegratorFamily family("integrator", "How a motion goes from one instant to the next.");
  return family;
}

double kinetic_energy(const AffineBlock& block, const Pose& velocity) {
  return velocity.dot(block.times_mass(velocity)) / 2;
}

}  // namespace dda
