#include "studies/dda/record/warnings/turning_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "continuation/state/acceptance.hpp"
#include "studies/dda/record/warnings/strength_left.hpp"

namespace dda {

namespace {

/// Of a side's length, from its corner to its Gauss point.
constexpr double inside = 0.5 - 0.5 / std::numbers::sqrt3;

/// What stands on a side.
struct SideContact {
  bool is_open = false, is_closed = false;
  bool may_turn = true;    ///< nothing but contact is left, of a mechanism or between separate bodies
  double compression = 0;  ///< borne by its closed points [F]
};

/// By interface and side.
using SideContacts = std::map<std::pair<int, std::size_t>, SideContact>;

SideContacts side_contacts(const Simulation& simulation) {
  const InterfaceSet& set = simulation.equilibrium().interfaces();
  const System& system = simulation.system();
  const LawValues laws = system.laws(simulation.walker().state());
  const bool moves_on =
      simulation.path().memory().is_mechanism;  // what has cracked turns as separate bodies do
  SideContacts out;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = set.points[p];
    const bool is_open = laws.opening[p].x() > 0;
    if (point.interface < 0 || (is_open && !point.is_separate() && holds_still(point, system.history()[p])))
      continue;
    SideContact& side = out[{point.interface, point.side}];
    (is_open ? side.is_open : side.is_closed) = true;
    side.may_turn = side.may_turn && (point.is_separate() || (moves_on && system.is_spent(p)));
    side.compression += std::max(0.0, -laws.traction[p].x()) * point.weight;
  }
  return out;
}

/// By how much of the moment of all loads about the structure's size what a side bears would turn about another place.
double share_of_moment(const Simulation& simulation, std::size_t side, double compression) {
  const System& system = simulation.system();
  const Side& at = simulation.assembly().sides[side];
  return compression * inside * (at.end - at.start).norm() /
         (load_on(system, simulation.walker().state()) * simulation.equilibrium().extent());
}

}  // namespace

std::string note_on_turning_contacts(const Simulation& simulation) {
  constexpr double counts = 0.01;
  const InterfaceSet& set = simulation.equilibrium().interfaces();
  std::set<std::string> names;
  std::size_t turning = 0;
  for (const auto& [key, side] : side_contacts(simulation)) {
    const std::string& name = set.names[static_cast<std::size_t>(key.first)];
    if (!side.is_open || !side.is_closed || std::ranges::find(set.gauss_names, name) == set.gauss_names.end())
      continue;
    if (!side.may_turn && share_of_moment(simulation, key.second, side.compression) < counts) continue;
    names.insert("'" + name + "'");
    ++turning;
  }
  if (turning == 0) return "";
  return fmt::format(
      "{} side{} of {} {} open at one of {} Gauss points and closed at the other: {} about a point 0.21 of "
      "its length inside the corner, which carries less than turning about the corner, down to 0.58 of it; "
      "`points: "
      "vertices` has bodies turn about their corners",
      turning, turning == 1 ? "" : "s", fmt::join(names, ", "), turning == 1 ? "is" : "are",
      turning == 1 ? "its" : "their", turning == 1 ? "it turns" : "each turns");
}

}  // namespace dda
