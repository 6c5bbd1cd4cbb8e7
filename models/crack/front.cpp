#include "models/crack/front.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "models/equilibrium/support.hpp"
#include "models/interface_book.hpp"

namespace dda {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double grazing = 6 * degree, largest_way_along = 60 * degree, same_aim = 1 * degree;
constexpr double sliver_turn = 2 * degree;
constexpr int most_turns = 12, most_aims = 3;
constexpr std::size_t most_blocks = 12;  // of a segment

double angle_between(const Vec2& a, const Vec2& b) { return std::abs(std::atan2(cross(a, b), a.dot(b))); }

/// 0, then to either side in turn, further and further.
double turn_of_try(int n) { return (n % 2 == 1 ? 1 : -1) * ((n + 1) / 2) * sliver_turn; }

/// ΔΠ ∝ ℓ^m between the lengths ℓ of two ways.
double at_length(double length, const std::pair<double, double>& one, const std::pair<double, double>& two) {
  const double m = std::log(two.second / one.second) / std::log(two.first / one.first);
  return one.second * std::pow(length / one.first, m);
}

}  // namespace

CrackFront::CrackFront(CrackGeometry& geometry, const Body& body, const ModelParameters& model)
    : geometry_(geometry), body_(body), model_(model), held_(points_held_along(body, model)) {
  Findings findings;
  InterfaceBook book(body, model, findings);
  findings.throw_if_any();
  constexpr double any = 1;
  for (int region = 0; region < static_cast<int>(body.assembly.regions.size()); ++region)
    if (const ThroughBlocks* through = book.through(region)) {
      const Interface& interface = book.law_of(*through);
      const InterfaceLaw& law = *interface.law;
      const double slope = law.steepest_slope(),
                   modulus = body.materials[static_cast<std::size_t>(region)]->modulus();
      resistance_[region] = {any * law.initial_kappa(any), slope > 0 ? modulus / (2 * slope) : 0,
                             interface.field};
    }
  for (std::size_t side = 0; side < body.assembly.sides.size(); ++side)
    if (const Interface& here = book.of_side(body.assembly.sides[side]); here.index >= 0)
      for (const CrackParameters& entry : model.cracks)
        if (std::ranges::find(entry.end_at, here.name) != entry.end_at.end()) ends_[side] = here.name;
  for (std::size_t e = 0; e < model.cracks.size(); ++e) {
    const CrackParameters& entry = model.cracks[e];
    rule_.push_back(entry.direction.make());
    for (const CrackBegin& begin : entry.begin)
      cracks_.push_back({e, locate(body.assembly, begin.at), begin.direction.normalized(), 0, {}});
  }
}

void CrackFront::begin() {
  for (int crack = 0; crack < static_cast<int>(num_cracks()); ++crack) {
    if (cut_ahead(crack, at(crack).direction)) continue;
    const CrackParameters& entry = parameters(crack);
    throw InputError(entry.where,
                     fmt::format("no crack can begin at ({:g}, {:g}) along ({:g}, {:g}): {}",
                                 at(crack).tip.x(), at(crack).tip.y(), at(crack).direction.x(),
                                 at(crack).direction.y(), why_not_from(at(crack).tip, end_of(crack))));
  }
}

/// A way begins on an outline: at the boundary, at the end of a slit or on the side of a block.
std::string CrackFront::why_not_from(const Vec2& x, const std::string& end) const {
  const std::vector<BlockId> around = blocks_at(body_.assembly, x, geometry_.tolerance());
  if (around.empty()) return "that lies outside every block";
  const auto& corners = body_.block(around.front()).outline.vertices;
  Vec2 nearest = corners.front();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &a = corners[i], way = corners[(i + 1) % corners.size()] - a,
               on = a + std::clamp(way.dot(x - a) / way.squaredNorm(), 0.0, 1.0) * way;
    if ((on - x).norm() < (nearest - x).norm()) nearest = on;
  }
  if ((nearest - x).norm() <= geometry_.tolerance()) return end;
  return fmt::format(
      "that lies inside a block, and cracks begin at the boundary, at the end of a slit or on a side "
      "of a block; the nearest is at ({:.6g}, {:.6g})",
      nearest.x(), nearest.y());
}

bool CrackFront::has_grown(int crack) const {
  return std::ranges::any_of(geometry_.cuts(),
                             [&](const Cut& cut) { return cut.crack == crack && !cut.is_provisional; });
}

std::vector<Cut> CrackFront::ahead_of(int crack) const {
  std::vector<Cut> out;
  std::ranges::copy_if(geometry_.cuts(), std::back_inserter(out),
                       [&](const Cut& cut) { return cut.crack == crack && cut.is_provisional; });
  return out;
}

Vec2 CrackFront::corner_near(BlockId block, const Vec2& x) const {
  constexpr double near = 1e-3;
  const auto& corners = body_.block(block).outline.vertices;
  const auto found = std::ranges::find_if(
      corners, [&](const Vec2& v) { return (v - x).norm() <= near * geometry_.block_size(); });
  return found == corners.end() ? x : *found;
}

bool CrackFront::is_met(const std::vector<Cut>& ahead) const {
  return std::ranges::any_of(ahead, [&](const Cut& mine) {
    return std::ranges::any_of(geometry_.cuts(), [&](const Cut& other) {
      return other.crack != mine.crack && distance(other.end, mine.start, mine.end) <= geometry_.tolerance();
    });
  });
}

bool CrackFront::passes(int crack, std::size_t side) const {
  const auto& wanted = parameters(crack).end_at;
  const auto end = ends_.find(side);
  return end == ends_.end() || std::ranges::find(wanted, end->second) == wanted.end();
}

std::string CrackFront::end_at(int crack, const Vec2& x, const Vec2& direction) const {
  const auto sides = geometry_.sides_at(x);
  const auto stop = std::ranges::find_if(sides, [&](std::size_t side) { return !passes(crack, side); });
  if (stop != sides.end() && !begins_at(crack, x)) return "interface '" + ends_.at(*stop) + "'";
  if (geometry_.is_on_crack(x, crack)) return "another crack";
  const auto block = geometry_.block_ahead(x, direction);
  if (!block) return "the boundary";
  const int region = body_.block(*block).region;
  if (is_open_to_cracks(region)) return {};
  return "region '" + body_.assembly.regions[static_cast<std::size_t>(region)].name + "'";
}

std::optional<Vec2> CrackFront::open_side(int crack, const Vec2& from, const Vec2& direction, double within) {
  const auto way = geometry_.way_along(from, direction);
  if (!way || way->angle > within) return {};
  const Side& side = body_.assembly.sides[way->side];
  const int region = body_.block(side.first).region;
  if (side.curve || body_.block(side.second).region != region || !is_open_to_cracks(region)) return {};
  if (!geometry_.open(way->side, from, way->end, crack)) return {};
  return way->end;
}

std::optional<Vec2> CrackFront::cut_once(int crack, const Vec2& from, const Vec2& direction) {
  if (auto end = open_side(crack, from, direction, grazing)) return end;
  at(crack).end = {end_at(crack, from, direction)};
  if (!end_of(crack).empty()) return {};
  const BlockId block = *geometry_.block_ahead(from, direction);
  const auto& cuts = geometry_.cuts();
  const auto last =
      std::find_if(cuts.rbegin(), cuts.rend(), [&](const Cut& cut) { return cut.crack == crack; });
  if (last != cuts.rend() && !last->side && last->block == block)
    return open_side(crack, from, direction, largest_way_along);
  if (auto end = cut_through(crack, block, from, direction)) return end;
  if (auto end = cut_from_corner(crack, from, direction)) return end;
  for (int n = 1; n <= most_turns; ++n)
    if (auto end = cut_through(crack, block, from, Eigen::Rotation2Dd(turn_of_try(n)) * direction))
      return end;
  at(crack).end = {"whichever way it takes, next to nothing of a block is cut off", true};
  return {};
}

std::optional<Vec2> CrackFront::cut_through(int crack, BlockId block, const Vec2& from,
                                            const Vec2& direction) {
  const auto exit = geometry_.exit(block, from, direction);
  if (!exit) return {};
  for (const Vec2& end : {corner_near(block, *exit), *exit})
    if (geometry_.cut(block, from, end, crack)) return end;
  return {};
}

std::optional<Vec2> CrackFront::cut_from_corner(int crack, const Vec2& from, const Vec2& direction) {
  for (const BlockId near : geometry_.blocks_near(from)) {
    const Vec2 corner = corner_near(near, from);
    const auto ahead = corner == from ? std::nullopt : geometry_.block_ahead(corner, direction);
    if (!ahead || !is_open_to_cracks(body_.block(*ahead).region)) continue;
    const auto on_both = [&](std::size_t side) {
      return distance(corner, body_.assembly.sides[side].start, body_.assembly.sides[side].end) <=
             geometry_.tolerance();
    };
    const auto sides = geometry_.sides_at(from);
    const auto between = std::ranges::find_if(sides, on_both);
    const bool is_opened = between != sides.end() && geometry_.open(*between, from, corner, crack);
    if (auto end = cut_through(crack, *ahead, corner, direction)) return end;
    if (is_opened) geometry_.drop_last();
  }
  return {};
}

bool CrackFront::cut_ahead(int crack, const Vec2& direction) {
  return cut_ahead(crack, direction, parameters(crack).shortest_segment * geometry_.block_size());
}

bool CrackFront::cut_ahead(int crack, const Vec2& direction, double length) {
  Vec2 from = at(crack).tip;
  std::size_t cuts = 0;
  while (cuts < most_blocks && (cuts == 0 || (from - at(crack).tip).norm() < length)) {
    const auto end = cut_once(crack, from, direction);
    if (!end) break;
    from = *end;
    ++cuts;
  }
  if (cuts > 0) at(crack).end = {};  // it ends behind this segment, which is found when that has grown
  return cuts > 0;
}

void CrackFront::replay(const Cut& cut) {
  const bool done = cut.side ? geometry_.open(*cut.side, cut.start, cut.end, cut.crack)
                             : geometry_.cut(cut.block, cut.start, cut.end, cut.crack);
  if (!done) throw std::runtime_error("a cut cannot be made again");
}

/// What other cracks have ahead of them stays, whatever came first.
void CrackFront::drop_ahead(int crack) {
  std::size_t left = ahead_of(crack).size();
  std::vector<Cut> others;
  for (; left > 0; geometry_.drop_last()) {
    const Cut& last = geometry_.cuts().back();
    if (last.crack == crack && last.is_provisional)
      --left;
    else
      others.push_back(last);
  }
  for (auto cut = others.rbegin(); cut != others.rend(); ++cut) replay(*cut);
  for (const Cut& cut : others)
    if (!cut.is_provisional) geometry_.confirm(cut);
}

std::optional<double> CrackFront::released(int crack, const Vec2& way, double length,
                                           const Surroundings& around) {
  const std::vector<Cut> cuts = geometry_.cuts();
  const std::vector<Memory> memory = cracks_;
  drop_ahead(crack);
  cut_ahead(crack, way, length);
  const std::vector<Cut> tried = ahead_of(crack);
  const auto up_to = [&](std::size_t count) {
    const double reached = (tried[count - 1].end - tried.front().start).norm();
    return std::pair(reached, around.released(std::span(tried).first(count)));
  };
  std::optional<double> out;
  if (tried.size() > 1)
    out = at_length(length, up_to(tried.size() - 1), up_to(tried.size()));
  else if (tried.size() == 1)
    out = at_length(length, {0.5 * up_to(1).first, 0.25 * up_to(1).second}, up_to(1));
  restore(cuts, memory);
  return out;
}

bool CrackFront::aim(int crack, const Surroundings& around) {
  const Memory memory = at(crack);
  const std::vector<Cut> cuts = geometry_.cuts(), ahead = ahead_of(crack);
  if (ahead.empty() || memory.aims >= most_aims || is_met(ahead)) return false;
  const int region = body_.block(ahead.front().block).region;
  const Resistance& resistance = resistance_.at(region);
  const CrackTip tip{memory.tip,
                     memory.direction,
                     has_grown(crack),
                     resistance.strength,
                     geometry_.block_size(),
                     resistance.characteristic_length,
                     around.stress,
                     [&](const Vec2& way, double length) { return released(crack, way, length, around); }};
  const Vec2 wanted = rule_[memory.entry]->aim(tip);
  ++at(crack).aims;
  if (angle_between(wanted, ahead.back().end - memory.tip) <= same_aim) return false;
  const std::vector<Memory> aimed = cracks_;
  drop_ahead(crack);
  if (cut_ahead(crack, wanted) && !std::ranges::equal(ahead_of(crack), ahead, {}, &Cut::end, &Cut::end))
    return true;
  restore(cuts, aimed);  // in their order, by which the structure counts them
  return false;
}

bool CrackFront::grow(int crack) {
  Memory& memory = at(crack);
  const std::vector<Cut> ahead = ahead_of(crack);
  for (const Cut& cut : ahead) geometry_.confirm(cut);
  memory.direction = (ahead.back().end - memory.tip).normalized();
  memory.tip = ahead.back().end;
  memory.aims = 0;
  // Next to the last bit of a section, pressed for a hinge, the stress ahead has no direction for it any more.
  const auto first = std::ranges::find(geometry_.cuts(), crack, &Cut::crack);
  if (memory.direction.dot(memory.tip - first->start) < 0) {
    memory.end = {"it turns back towards its beginning", true};
    return false;
  }
  return cut_ahead(crack, memory.direction);
}

bool CrackFront::may_have(const std::vector<Memory>& cracks) const {
  std::vector<std::size_t> count(model_.cracks.size(), 0);
  for (const Memory& crack : cracks) {
    if (crack.entry >= count.size()) return false;
    ++count[crack.entry];
  }
  for (std::size_t e = 0; e < count.size(); ++e) {
    const CrackParameters& entry = model_.cracks[e];
    if (entry.is_automatic() ? count[e] == 0 : count[e] != entry.begin.size()) return false;
  }
  return true;
}

void CrackFront::restore(const std::vector<Cut>& cuts, std::vector<Memory> memory) {
  while (!geometry_.empty()) geometry_.drop_last();
  for (const Cut& cut : cuts) {
    replay(cut);
    if (!cut.is_provisional) geometry_.confirm(cut);
  }
  cracks_ = std::move(memory);
}

}  // namespace dda
