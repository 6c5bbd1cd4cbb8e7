#include "models/interface/softening/softening_parameters.hpp"

#include <cmath>
#include <numbers>

namespace dda {

SofteningNumbers SofteningParameters::numbers() const {
  return {.strength = tensile_strength,
          .fracture_energy = fracture_energy,
          .shear_fracture_energy = shear_fracture_energy.value_or(fracture_energy),
          .mixed_mode_exponent = mixed_mode_exponent.value_or(1),
          .shear_weight = cohesion ? *cohesion / tensile_strength : shear_weight.value_or(1),
          .friction = std::tan(friction_angle * std::numbers::pi / 180)};
}

void SofteningParameters::check(const Position& where, Findings& findings) const {
  if (cohesion && shear_weight)
    findings.add(where,
                 "`shear_weight` does nothing beside `cohesion`, which makes it cohesion/tensile_strength: "
                 "give one of them");
  if (mixed_mode_exponent && !shear_fracture_energy)
    findings.add(where, "`mixed_mode_exponent` does nothing without a `shear_fracture_energy`");
}

}  // namespace dda
