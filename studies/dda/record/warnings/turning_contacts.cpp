#include "studies/dda/record/warnings/turning_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace dda {

std::string note_on_turning_contacts(const Simulation& simulation) {
  struct SideContact {
    bool is_open = false, is_closed = false;
  };
  const InterfaceSet& set = simulation.equilibrium().interfaces();
  const LawValues laws = simulation.system().laws(simulation.walker().state());
  const bool moves_on = simulation.path().memory().is_mechanism;  // what has cracked turns as separate bodies do
  std::map<std::pair<int, std::size_t>, SideContact> sides;
  for (std::size_t p = 0; p < laws.opening.size(); ++p) {
    const InterfacePoint& point = set.points[p];
    const bool may_turn = point.is_separate() || (moves_on && simulation.system().is_spent(p));
    if (!may_turn || point.interface < 0) continue;
    SideContact& side = sides[{point.interface, point.side}];
    (laws.opening[p].x() > 0 ? side.is_open : side.is_closed) = true;
  }
  std::set<std::string> names;
  std::size_t turning = 0;
  for (const auto& [key, side] : sides) {
    const std::string& name = set.names[static_cast<std::size_t>(key.first)];
    if (!side.is_open || !side.is_closed || std::ranges::find(set.gauss_names, name) == set.gauss_names.end())
      continue;
    names.insert("'" + name + "'");
    ++turning;
  }
  if (turning == 0) return "";
  return fmt::format(
      "{} side{} of {} {} open at one of {} Gauss points and closed at the other: {} about a point 0.21 of "
      "its length "
      "inside the corner, which carries less than turning about the corner, down to 0.58 of it; `points: "
      "vertices` has "
      "separate bodies turn about their corners",
      turning, turning == 1 ? "" : "s", fmt::join(names, ", "), turning == 1 ? "is" : "are",
      turning == 1 ? "its" : "their", turning == 1 ? "it turns" : "each turns");
}

}  // namespace dda
