#include "studies/dda/record/warnings/coarse_zones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace dda {
namespace {

constexpr double longest_side = 0.5, good_side = 1.0 / 3;  // h/l

/// Sums over the sides of an interface.
struct Tally {
  double length = 0, length_squared = 0, zone = 0;
  std::size_t sides = 0;
};

}  // namespace

std::vector<CoarseZone> coarse_zones(const Simulation& simulation) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  std::vector<Tally> tallies(equilibrium.interfaces().names.size());
  std::set<std::size_t> counted;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    const double slope = point.law->steepest_slope();
    if (point.cut) continue;
    if (point.interface < 0 || slope <= 0 || !std::isfinite(slope) || !counted.insert(point.side).second)
      continue;
    const Side& side = simulation.assembly().sides[point.side];
    const double length = (side.end - side.start).norm();
    const double modulus = std::min(simulation.body().material(side.first).modulus(),
                                    simulation.body().material(side.second).modulus());
    Tally& tally = tallies[static_cast<std::size_t>(point.interface)];
    tally.length += length;
    tally.length_squared += length * length;
    tally.zone += length * modulus / (2 * slope);
    ++tally.sides;
  }
  std::vector<CoarseZone> out;
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const Tally& t = tallies[i];
    if (t.sides > 1 && t.length_squared > longest_side * t.zone)
      out.push_back({i, t.length_squared / t.length, t.zone / t.length});
  }
  return out;
}

std::vector<CoarseZone> cracked_coarse_zones(const Simulation& simulation) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  const std::vector<History>& history = simulation.system().history();
  std::vector<CoarseZone> out = coarse_zones(simulation);
  std::erase_if(out, [&](const CoarseZone& zone) {
    for (std::size_t p = 0; p < history.size(); ++p)
      if (equilibrium.point(p).interface == static_cast<int>(zone.interface) && history[p].dissipated > 0)
        return false;
    return true;
  });
  return out;
}

std::string text(const Simulation& simulation, const CoarseZone& zone) {
  const std::string unit = simulation.deck().units.length;
  return fmt::format(
      "interface '{}': its sides of {:.3g} {} are too long for the cohesive zone of a crack, l = E/(2 × "
      "steepest "
      "softening) = {:.3g} {} (E Gf/ft² where that is straight): peaks may be too high by {}; make blocks "
      "{:.2g} "
      "times as large, with sides of {:.2g} {}, or take a larger fracture energy",
      simulation.equilibrium().interfaces().names[zone.interface], zone.side, unit, zone.length, unit,
      zone.side > 0.6 * zone.length ? "ten or some tens of percent" : "several percent",
      good_side * zone.length / zone.side, good_side * zone.length, unit);
}

}  // namespace dda
