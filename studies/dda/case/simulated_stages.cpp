// How a simulation gets from one stage to the next.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

#include "continuation/detour/dead_load.hpp"
#include "studies/dda/case/simulation.hpp"
#include "studies/dda/case/turning_places.hpp"

namespace dda {
namespace {

/// What may help where bodies that only touch carry no load; "" where they turn about their corners.
std::string hint_on_turning(const Equilibrium& equilibrium, const Body& body) {
  const InterfaceSet& set = equilibrium.interfaces();
  const auto places = turning_places(set, body.thickness);
  for (const InterfacePoint& point : set.points) {
    if (!point.is_separate() || point.interface < 0) continue;
    const auto place = places.find(SideKey(point));
    if (place == places.end()) continue;
    return fmt::format(
        "; the sides of '{}' turn about Gauss points, {:.2f} of their length inside their corners, and may "
        "carry "
        "it about the corners: {}",
        set.names[static_cast<std::size_t>(point.interface)], place->second.inside, place->second.remedy());
  }
  return "";
}

}  // namespace

std::string Simulation::apply_dead_loads() {
  const auto scope = timings_.measure("dead loads");
  const std::size_t stages = equilibrium_->stages().size();
  for (std::size_t stage = 0; stage + 1 < stages; ++stage) {
    walker_->begin_stage(stage);
    if (std::string why = apply_full_stage(*walker_); !why.empty())
      return "stage '" + walker_->system().loading().name + "' cannot be carried: " + why + hindrance_ +
             hint_on_turning(*equilibrium_, *body_);
  }
  change_supports();
  walker_->begin_stage(stages - 1);
  return {};
}

void Simulation::change_supports(const SupportChange& change) {
  if (change.rest.empty() && change.borne.empty()) return;
  walker_->follow([&] {
    equilibrium_->change_supports(*body_, deck_, change);
    return Growth::unchanged(*equilibrium_);
  });
  walker_->leave_behind(change.energy);
}

void Simulation::change_supports() {
  change_supports(equilibrium_->support_change(walker_->state().d.all()));
}

void Simulation::go_through(const StageHistory& history) {
  std::span<const double> rest(history.rest), borne(history.borne);
  const auto next = [this](std::span<const double>& from, std::size_t count) {
    if (from.size() < count)
      throw InputError(deck_.where, "the run has other supports that come and go than the deck");
    const auto first = std::exchange(from, from.subspan(count)).first(count);
    return std::vector<double>(first.begin(), first.end());
  };
  for (std::size_t held = 0;; ++held) {
    change_supports({.rest = next(rest, equilibrium_->springs_to_add().size()),
                     .borne = next(borne, equilibrium_->springs_to_remove().size())});
    if (held == history.held_load_factors.size()) break;
    equilibrium_->hold(*body_, deck_, history.held_load_factors[held]);
  }
  walker_->begin_stage(equilibrium_->stages().size() - 1);
  gauges_.gauges = loading().gauges;
}

void Simulation::go_on_with_last_stage(const std::string& reason) {
  equilibrium_->append_stage(*body_, deck_);
  require_loads();
  path_->begin_next_stage(reason);
}

void Simulation::hold_loads(double load_factor) {
  equilibrium_->hold(*body_, deck_, load_factor);
  change_supports();
  walker_->begin_stage(equilibrium_->stages().size() - 1);
  gauges_.gauges = loading().gauges;
}

}  // namespace dda
