// Cracks that begin where stress asks for one.
#include <algorithm>
#include <iterator>

#include "framework/base/errors.hpp"
#include "models/crack/front.hpp"

namespace dda {
namespace {

constexpr double near = 2;  // in block sizes: the same place

/// As if all of a stress came with the load.
BlockStress growing_from_none(const std::vector<Vec3>& stress) {
  return {std::vector<Vec3>(stress.size(), Vec3::Zero()), stress};
}

}  // namespace

bool CrackFront::is_automatic() const {
  return std::ranges::any_of(model_.cracks, &CrackParameters::is_automatic);
}

CrackStarts::Wish CrackFront::wish_of(std::size_t entry) const {
  constexpr double of_zone = 0.3;
  const CrackParameters& p = model_.cracks[entry];
  CrackStarts::Wish out{.held = held_};
  double zone = 0;
  for (const auto& [region, resistance] : resistance_) {
    const std::string& name = body_.assembly.regions[static_cast<std::size_t>(region)].name;
    if (std::ranges::find(p.through_blocks, name) == p.through_blocks.end()) continue;
    out.strength[region] = {resistance.strength, resistance.field ? &*resistance.field : nullptr};
    zone = std::max(zone, resistance.characteristic_length);
  }
  out.apart = p.apart.value_or(std::max(next_to_a_crack * geometry_.block_size(), of_zone * zone));
  return out;
}

void CrackFront::begin_where_asked(const std::vector<BlockStress>& elastic) {
  for (std::size_t e = 0; e < model_.cracks.size(); ++e) {
    if (!model_.cracks[e].is_automatic()) continue;
    const bool is_cut = std::ranges::any_of(elastic, [&](const BlockStress& stress) {
      const auto places = CrackStarts(geometry_, body_).places(stress, wish_of(e));
      return std::ranges::any_of(places, [&](const CrackStart& place) {
        return start({e, place, std::nullopt}).has_value();
      });
    });
    if (!is_cut)
      throw InputError(
          model_.cracks[e].where,
          "no crack can begin by itself: the loads cause no tension where the regions end, or none "
          "that is as far from other cracks as `apart` says");
  }
}

std::optional<CrackFront::Asked> CrackFront::asked(const std::vector<Vec3>& stress,
                                                   const std::set<int>& spent_on) {
  const BlockStress all = growing_from_none(stress);
  for (std::size_t e = 0; e < model_.cracks.size(); ++e)
    if (auto out = model_.cracks[e].is_automatic() ? asked_of(e, all, spent_on) : std::nullopt) return out;
  return {};
}

bool CrackFront::is_near(int crack, const Vec2& x) const {
  return (x - at(crack).tip).norm() <= near * geometry_.block_size();
}

std::optional<int> CrackFront::ready(std::size_t entry, const std::set<int>& spent_on) const {
  std::optional<int> out;
  for (int crack = 0; crack < static_cast<int>(num_cracks()); ++crack)
    if (at(crack).entry == entry && !has_grown(crack) && !spent_on.contains(crack) &&
        !is_met(ahead_of(crack)))
      out = crack;
  return out;
}

std::int64_t CrackFront::num_begun(std::size_t entry) const {
  std::int64_t out = 0;
  for (int crack = 0; crack < static_cast<int>(num_cracks()); ++crack) {
    if (at(crack).entry != entry) continue;
    const auto first = std::ranges::find(geometry_.cuts(), crack, &Cut::crack);
    const bool cuts_off_a_corner =
        !end_of(crack).empty() && first != geometry_.cuts().end() &&
        (at(crack).tip - first->start).norm() < next_to_a_crack * geometry_.block_size();
    if (!cuts_off_a_corner) ++out;
  }
  return out;
}

std::optional<CrackFront::Asked> CrackFront::left_out(const std::vector<Vec3>& stress) const {
  const BlockStress all = growing_from_none(stress);
  std::optional<Asked> out;
  for (std::size_t e = 0; e < model_.cracks.size(); ++e) {
    CrackStarts::Wish wish = wish_of(e);
    wish.apart = next_to_a_crack * geometry_.block_size();
    const auto places = CrackStarts(geometry_, body_).places(all, wish);
    if (!places.empty() && (!out || places.front().load_factor < out->start.load_factor))
      out = Asked{e, places.front(), std::nullopt};
  }
  return out;
}

std::vector<ShallowCorner> CrackFront::shallow_corners() const {
  std::vector<ShallowCorner> out;
  for (std::size_t e = 0; e < model_.cracks.size(); ++e)
    if (model_.cracks[e].is_automatic())
      std::ranges::move(CrackStarts(geometry_, body_).shallow(wish_of(e).strength), std::back_inserter(out));
  return out;
}

std::optional<CrackFront::Asked> CrackFront::first_to_cut(std::size_t entry,
                                                          std::span<const CrackStart> places,
                                                          std::optional<int> moved) {
  const std::vector<Cut> cuts = geometry_.cuts();
  const std::vector<Memory> memory = cracks_;
  for (const CrackStart& place : places) {
    const Asked out{entry, place, moved};
    if (!start(out)) continue;
    restore(cuts, memory);
    return out;
  }
  return {};
}

std::optional<CrackFront::Asked> CrackFront::asked_of(std::size_t entry, const BlockStress& stress,
                                                      const std::set<int>& spent_on) {
  constexpr double enough = 0.9;
  CrackStarts::Wish wish = wish_of(entry);
  wish.except = ready(entry, spent_on);
  if (num_begun(entry) >= model_.cracks[entry].most.value_or(1) && !wish.except) return {};
  const auto places = CrackStarts(geometry_, body_).places(stress, wish);
  const auto last = std::ranges::upper_bound(places, 1 / enough, {}, &CrackStart::load_factor);
  if (last != places.begin() && wish.except && is_near(*wish.except, places.front().at)) return {};
  return first_to_cut(entry, {places.begin(), last}, wish.except);
}

std::optional<CrackFront::Asked> CrackFront::asked_sooner(const BlockStress& growing) {
  constexpr double sooner = 0.99;
  for (std::size_t e = 0; e < model_.cracks.size(); ++e) {
    const std::optional<int> crack = model_.cracks[e].is_automatic() ? ready(e, {}) : std::nullopt;
    if (!crack) continue;
    CrackStarts::Wish wish = wish_of(e);
    wish.except = crack;
    const auto places = CrackStarts(geometry_, body_).places(growing, wish);
    const auto here =
        std::ranges::find_if(places, [&](const CrackStart& place) { return is_near(*crack, place.at); });
    const auto last = here == places.end() ? here
                                           : std::ranges::lower_bound(places, sooner * here->load_factor, {},
                                                                      &CrackStart::load_factor);
    if (auto out = first_to_cut(e, {places.begin(), last}, crack)) return out;
  }
  return {};
}

std::optional<int> CrackFront::start(const Asked& crack) {
  const int number = crack.moved.value_or(static_cast<int>(num_cracks()));
  const std::vector<Cut> cuts = geometry_.cuts();
  const std::vector<Memory> memory = cracks_;
  if (crack.moved)
    drop_ahead(number);
  else
    cracks_.emplace_back();
  at(number) = {crack.entry, crack.start.at, crack.start.direction, 0, {}};
  const double least = parameters(number).shortest_segment * geometry_.block_size();
  if (cut_ahead(number, crack.start.direction) &&
      (ahead_of(number).back().end - at(number).tip).norm() >= least)  // else it cuts off a corner
    return number;
  restore(cuts, memory);
  return {};
}

}  // namespace dda
