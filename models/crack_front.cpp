#include "models/crack_front.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/interface_book.hpp"

namespace dda {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double grazing = 6 * degree, largest_way_along = 60 * degree, same_aim = 1 * degree;
constexpr double sliver_turn = 2 * degree;
constexpr int most_turns = 12, most_aims = 3;
constexpr std::size_t most_blocks = 6;  // of a segment

double angle_between(const Vec2& a, const Vec2& b) { return std::abs(std::atan2(cross(a, b), a.dot(b))); }

/// 0, then to either side in turn, further and further.
double turn_of_try(int n) { return (n % 2 == 1 ? 1 : -1) * ((n + 1) / 2) * sliver_turn; }

}  // namespace

CrackFront::CrackFront(CrackGeometry& geometry, const Body& body, const ModelParameters& model)
    : geometry_(geometry), body_(body), model_(model) {
  Findings findings;
  InterfaceBook book(body, model, findings);
  findings.throw_if_any();
  for (const CrackParameters& entry : model.cracks) {
    rule_.push_back(entry.direction.make());
    for (const CrackBegin& begin : entry.begin) {
      const auto crack = static_cast<int>(cracks_.size());
      constexpr double any = 1;
      strength_.push_back(any * book.law_of(book.of_crack(crack)).law->initial_kappa(any));
      cracks_.push_back({locate(body.assembly, begin.at), begin.direction.normalized(), 0, {}});
    }
  }
}

void CrackFront::begin() {
  for (int crack = 0; crack < static_cast<int>(num_cracks()); ++crack) {
    if (cut_ahead(crack, at(crack).direction)) continue;
    const CrackParameters& entry = parameters(crack);
    throw InputError(entry.where, fmt::format("no crack can begin at ({:g}, {:g}) along ({:g}, {:g}): {}",
                                              at(crack).tip.x(), at(crack).tip.y(), at(crack).direction.x(),
                                              at(crack).direction.y(), at(crack).end));
  }
}

std::vector<Cut> CrackFront::ahead_of(int crack) const {
  std::vector<Cut> out;
  std::ranges::copy_if(geometry_.cuts(), std::back_inserter(out),
                       [&](const Cut& cut) { return cut.crack == crack && cut.is_provisional; });
  return out;
}

bool CrackFront::is_inside(int crack, BlockId block) const {
  const auto& regions = parameters(crack).through_blocks;
  const auto region = static_cast<std::size_t>(body_.block(block).region);
  return std::ranges::find(regions, body_.assembly.regions[region].name) != regions.end();
}

bool CrackFront::passes(int crack, std::size_t side) const {
  const auto& curve = body_.assembly.sides[side].curve;
  if (!curve) return true;
  const auto& ends = parameters(crack).end_at;
  return std::ranges::find(ends, body_.assembly.curves[static_cast<std::size_t>(*curve)]) == ends.end();
}

std::string CrackFront::end_at(int crack, const Vec2& x, const Vec2& direction) const {
  const auto sides = geometry_.sides_at(x);
  const auto stop = std::ranges::find_if(sides, [&](std::size_t side) { return !passes(crack, side); });
  if (stop != sides.end())
    return "interface '" +
           body_.assembly.curves[static_cast<std::size_t>(*body_.assembly.sides[*stop].curve)] + "'";
  const auto block = geometry_.block_ahead(x, direction);
  if (!block) return "the boundary";
  if (!is_inside(crack, *block)) return "another region";
  return {};
}

std::optional<Vec2> CrackFront::open_side(int crack, const Vec2& from, const Vec2& direction, double within) {
  const auto way = geometry_.way_along(from, direction);
  if (!way || way->angle > within) return {};
  const Side& side = body_.assembly.sides[way->side];
  if (side.curve || !is_inside(crack, side.first) || !is_inside(crack, side.second)) return {};
  if (!geometry_.open(way->side, from, way->end, crack)) return {};
  return way->end;
}

std::optional<Vec2> CrackFront::cut_once(int crack, const Vec2& from, const Vec2& direction) {
  if (auto end = open_side(crack, from, direction, grazing)) return end;
  at(crack).end = end_at(crack, from, direction);
  if (!at(crack).end.empty()) return {};
  const BlockId block = *geometry_.block_ahead(from, direction);
  const auto& cuts = geometry_.cuts();
  const auto last =
      std::find_if(cuts.rbegin(), cuts.rend(), [&](const Cut& cut) { return cut.crack == crack; });
  if (last != cuts.rend() && !last->side && last->block == block)
    return open_side(crack, from, direction, largest_way_along);
  for (int n = 0; n <= most_turns; ++n) {
    const Vec2 along = Eigen::Rotation2Dd(turn_of_try(n)) * direction;
    const auto exit = geometry_.exit(block, from, along);
    if (!exit) continue;
    if (exit->on_cut) {
      at(crack).end = "another crack";
      return {};
    }
    if (geometry_.cut(block, from, exit->at, crack)) return exit->at;
  }
  at(crack).end = "a corner that cannot be cut";
  return {};
}

bool CrackFront::cut_ahead(int crack, const Vec2& direction) {
  Vec2 from = at(crack).tip;
  std::size_t cuts = 0;
  const double wanted = parameters(crack).shortest_segment * geometry_.block_size();
  while (cuts < most_blocks && (cuts == 0 || (from - at(crack).tip).norm() < wanted)) {
    const auto end = cut_once(crack, from, direction);
    if (!end) break;
    from = *end;
    ++cuts;
  }
  if (cuts > 0) at(crack).end.clear();  // it ends behind this segment, which is found when that has grown
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

bool CrackFront::aim(int crack, const Stress& stress) {
  Memory& memory = at(crack);
  const std::vector<Cut> ahead = ahead_of(crack);
  if (ahead.empty() || memory.aims >= most_aims) return false;
  const CrackTip tip{memory.tip, memory.direction, strength_[static_cast<std::size_t>(crack)],
                     geometry_.block_size(), stress};
  const Vec2 wanted = rule_[model_.entry_of_crack(crack)]->aim(tip);
  ++memory.aims;
  if (angle_between(wanted, ahead.back().end - memory.tip) <= same_aim) return false;
  drop_ahead(crack);
  if (!cut_ahead(crack, wanted)) {
    for (const Cut& cut : ahead) replay(cut);
    memory.end.clear();
    return false;
  }
  const std::vector<Cut> now = ahead_of(crack);
  return !std::ranges::equal(now, ahead, {}, &Cut::end, &Cut::end);
}

bool CrackFront::grow(int crack) {
  Memory& memory = at(crack);
  const std::vector<Cut> ahead = ahead_of(crack);
  for (const Cut& cut : ahead) geometry_.confirm(cut);
  memory.direction = (ahead.back().end - memory.tip).normalized();
  memory.tip = ahead.back().end;
  memory.aims = 0;
  return cut_ahead(crack, memory.direction);
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
