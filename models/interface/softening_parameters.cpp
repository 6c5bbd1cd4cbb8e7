#include "models/interface/softening_parameters.hpp"

#include <cmath>
#include <numbers>

namespace dda {

SofteningNumbers SofteningParameters::numbers() const {
  return {.strength = tensile_strength,
          .fracture_energy = fracture_energy,
          .shear_fracture_energy = shear_fracture_energy.value_or(fracture_energy),
          .mixed_mode_exponent = mixed_mode_exponent,
          .shear_weight = cohesion ? *cohesion / tensile_strength : shear_weight,
          .friction = std::tan(friction_angle * std::numbers::pi / 180)};
}

}  // namespace dda
