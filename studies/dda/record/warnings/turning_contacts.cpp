#include "studies/dda/record/warnings/turning_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "continuation/state/acceptance.hpp"
#include "studies/dda/case/turning_places.hpp"
#include "studies/dda/record/warnings/strength_left.hpp"

namespace dda {

namespace {

/// What stands on a side.
struct SideContact {
  bool is_open = false, is_closed = false;
  bool may_turn = true;    ///< nothing but contact is left, of a mechanism or between separate bodies
  double compression = 0;  ///< borne by its closed points [F]
};

using SideContacts = std::map<SideKey, SideContact>;

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
    SideContact& side = out[SideKey(point)];
    (is_open ? side.is_open : side.is_closed) = true;
    side.may_turn = side.may_turn && (point.is_separate() || (moves_on && system.is_spent(p)));
    side.compression += std::max(0.0, -laws.traction[p].x()) * point.weight;
  }
  return out;
}

/// By how much of the moment of all loads about the structure's size what a side bears would turn about another place.
double share_of_moment(const Simulation& simulation, const TurningPlace& place, double compression) {
  return compression * place.inside * place.length /
         (load_on(simulation.system(), simulation.walker().state()) * simulation.equilibrium().extent());
}

/// Sides that turn alike.
struct Turning {
  std::set<std::string> names;
  std::size_t sides = 0;
};

std::string text_of(const TurningPlace& place, const Turning& turning) {
  const bool is_one = turning.sides == 1;
  return fmt::format(
      "{} side{} of {} {} open at one of {} {} Gauss points and closed at {}: {} about a point {:.2f} of "
      "its length inside the corner, which carries less than turning about the corner, down to {:.2f} of it; "
      "{}",
      turning.sides, is_one ? "" : "s", fmt::join(turning.names, ", "), is_one ? "is" : "are",
      is_one ? "its" : "their", place.num_points, place.num_points == 2 ? "the other" : "another",
      is_one ? "it turns" : "each turns", place.inside, place.carried(), place.remedy());
}

}  // namespace

std::string note_on_turning_contacts(const Simulation& simulation) {
  constexpr double counts = 0.01;
  const InterfaceSet& set = simulation.equilibrium().interfaces();
  const auto places = turning_places(set, simulation.body().thickness);
  std::map<std::pair<std::size_t, bool>, std::pair<TurningPlace, Turning>> kinds;
  for (const auto& [key, side] : side_contacts(simulation)) {
    const auto place = places.find(key);
    if (!side.is_open || !side.is_closed || place == places.end()) continue;
    if (!side.may_turn && share_of_moment(simulation, place->second, side.compression) < counts) continue;
    auto& [of, turning] = kinds[{place->second.num_points, place->second.is_second_order}];
    of = place->second;
    turning.names.insert("'" + set.names[static_cast<std::size_t>(key.interface)] + "'");
    ++turning.sides;
  }
  std::vector<std::string> out;
  for (const auto& [kind, found] : kinds) out.push_back(text_of(found.first, found.second));
  return fmt::format("{}", fmt::join(out, ". "));
}

}  // namespace dda
