#include "studies/dda/record/warnings/unlikely_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "continuation/state/acceptance.hpp"

namespace dda {
namespace {

constexpr double least_strain = 1e-8, longest_zone = 100;

struct Numbers {
  double modulus, strength, zone;
};

Numbers numbers_of(const Simulation& simulation, const InterfacePoint& point) {
  const double modulus = std::min(simulation.body().material(point.first).modulus(),
                                  simulation.body().material(point.second).modulus());
  const double strength = point.stiffness * point.law->initial_kappa(point.stiffness);
  return {modulus, strength, modulus / (2 * point.law->steepest_slope())};
}

}  // namespace

std::vector<std::string> unlikely_numbers(const Simulation& simulation) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  const double size = equilibrium.extent();
  std::set<int> seen;
  std::vector<std::string> out;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    const double slope = point.law->steepest_slope();
    if (point.interface < 0 || !(slope > 0) || !std::isfinite(slope)) continue;
    const Numbers now = numbers_of(simulation, point);
    const bool is_stiff = now.strength / now.modulus < least_strain;
    const bool is_tough = now.zone > longest_zone * size;
    if ((!is_stiff && !is_tough) || !seen.insert(point.interface).second) continue;
    const std::string& name = equilibrium.interfaces().names[static_cast<std::size_t>(point.interface)];
    out.push_back(
        is_stiff ? fmt::format(
                       "'{}' cracks at a strain ft/E of {:.2g}: do the young_modulus and the strength have "
                       "the units of the deck?",
                       name, now.strength / now.modulus)
                 : fmt::format("'{}' has a length E Gf/ft² of {:.3g} beside a structure of {:.3g}: do the "
                               "fracture_energy and the strength have the units of the deck?",
                               name, now.zone, size));
  }
  return out;
}

}  // namespace dda
