#pragma once

#include <optional>
#include <string>

#include "framework/deck/schema.hpp"
#include "models/interface/softening/damage_law.hpp"

namespace dda {

/// The deck's keys of a softening joint.
struct SofteningParameters {
  double tensile_strength = 0;
  double fracture_energy = 0;
  std::optional<double> shear_fracture_energy;
  std::optional<double> mixed_mode_exponent;
  std::optional<double> cohesion;
  std::optional<double> shear_weight;
  double friction_angle = 0;

  SofteningNumbers numbers() const;
  /// What would do nothing beside the others is a finding.
  void check(const Position& where, Findings& findings) const;
};

/// The same keys for every softening curve.
template <class P = SofteningParameters>
Schema<P> softening_schema(const std::string& text) {
  return Schema<P>(text)
      .number("tensile_strength", &P::tensile_strength,
              {.dimension = dimension::stress,
               .bounds = above(0),
               .text = "Traction ft at which the interface starts to crack."})
      .number("fracture_energy", &P::fracture_energy,
              {.dimension = dimension::energy_per_area,
               .bounds = above(0),
               .text = "Energy Gf per area of a complete crack opened in pure tension."})
      .number("shear_fracture_energy", &P::shear_fracture_energy,
              {.dimension = dimension::energy_per_area,
               .bounds = above(0),
               .text = "Energy per area of a complete crack in pure sliding, friction apart; Gf if absent."})
      .number(
          "mixed_mode_exponent", &P::mixed_mode_exponent,
          {.bounds = at_least(1),
           .text =
               "Exponent η of Gf(M) = Gf_I + (Gf_II − Gf_I) M^η, M the share of sliding in the energy, with "
               "`shear_fracture_energy`; 1 if absent."})
      .number("cohesion", &P::cohesion,
              {.dimension = dimension::stress,
               .bounds = above(0),
               .text = "Shear strength c without normal traction; shear_weight · ft if absent."})
      .number(
          "shear_weight", &P::shear_weight,
          {.bounds = above(0),
           .text = "Weight β of sliding against opening in q_eq = sqrt(<q_n>² + (β q_s)²), in the place of "
                   "`cohesion`, which makes it c/ft; 1 without either."})
      .number(
          "friction_angle", &P::friction_angle,
          {.fallback = 0.0,
           .bounds = at_least(0) & below(90),
           .text = "Friction angle in degrees: closed joints slide at c − t_n tan φ, cracks at −t_n tan φ."})
      .check([](const P& p, const Position& where, Findings& findings) { p.check(where, findings); });
}

}  // namespace dda
