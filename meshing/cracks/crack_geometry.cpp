#include "meshing/cracks/crack_geometry.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "meshing/cracks/chord.hpp"

namespace dda {
namespace {

constexpr double nothing = 1e-9;  // in block sizes

double median_size(const Assembly& assembly) {
  std::vector<double> areas;
  for (const Block& block : assembly.blocks) areas.push_back(block.moments.area);
  const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
  std::ranges::nth_element(areas, middle);
  return std::sqrt(*middle);
}

std::vector<Box> boxes_of(const Assembly& assembly, double margin) {
  std::vector<Box> out;
  for (const Block& block : assembly.blocks)
    out.push_back(bounding_box(block.outline.vertices).inflated(margin));
  return out;
}

}  // namespace

CrackGeometry::CrackGeometry(const Assembly& assembly)
    : assembly_(assembly),
      block_size_(median_size(assembly)),
      smallest_{nothing * block_size_, nothing * block_size_ * block_size_},
      grid_(boxes_of(assembly, smallest_.length)),
      sides_of_(assembly.num_blocks()),
      boundary_of_(assembly.num_blocks()) {
  for (std::size_t s = 0; s < assembly.sides.size(); ++s)
    for (const BlockId block : {assembly.sides[s].first, assembly.sides[s].second})
      sides_of_[block.value()].push_back(s);
  for (std::size_t s = 0; s < assembly.boundary.size(); ++s)
    boundary_of_[assembly.boundary[s].block.value()].push_back(s);
}

bool CrackGeometry::is_between(const Vec2& x, const Vec2& start, const Vec2& end) const {
  return distance(x, start, end) <= tolerance() && (x - start).norm() > tolerance() &&
         (x - end).norm() > tolerance();
}

void CrackGeometry::mark(const Cut& by) {
  for (const Vec2& x : {by.start, by.end}) {
    for (const std::size_t s : sides_of_[by.block.value()])
      if (is_between(x, assembly_.sides[s].start, assembly_.sides[s].end))
        on_sides_[s].push_back({cuts_.size(), x});
    for (const std::size_t s : boundary_of_[by.block.value()])
      if (is_between(x, assembly_.boundary[s].start, assembly_.boundary[s].end))
        on_boundary_[s].push_back({cuts_.size(), x});
  }
  if (by.side) on_sides_[*by.side].push_back({cuts_.size(), by.start});  // divided, be it into one piece
}

bool CrackGeometry::cut(BlockId block, const Vec2& start, const Vec2& end, int crack) {
  const auto at = divided_.try_emplace(block, assembly_.blocks[block.value()].outline).first;
  if (!at->second.divide(JumpId{jumps_.size()}, start, end, smallest_)) {
    if (at->second.parts().size() == 1) divided_.erase(at);
    return false;
  }
  const Cut made{block, start, end, crack};
  mark(made);
  jumps_.push_back(cuts_.size());
  cuts_.push_back(made);
  return true;
}

bool CrackGeometry::open(std::size_t side, const Vec2& start, const Vec2& end, int crack) {
  if ((end - start).norm() <= tolerance() || is_open(side, (start + end) / 2)) return false;
  const Cut made{assembly_.sides[side].first, start, end, crack, side};
  mark(made);
  cuts_.push_back(made);
  return true;
}

void CrackGeometry::confirm(const Cut& cut) {
  for (Cut& mine : cuts_)
    if (mine.is_at(cut)) mine.is_provisional = false;
}

void CrackGeometry::drop_last() {
  assert(!cuts_.empty());
  const Cut last = cuts_.back();
  cuts_.pop_back();
  for (Marks* marks : {&on_sides_, &on_boundary_}) {
    for (auto& [side, on_it] : *marks)
      std::erase_if(on_it, [&](const Mark& mark) { return mark.cut == cuts_.size(); });
    std::erase_if(*marks, [](const auto& side) { return side.second.empty(); });
  }
  if (last.side) return;
  jumps_.pop_back();
  DividedBlock& block = divided_.at(last.block);
  block = DividedBlock(assembly_.blocks[last.block.value()].outline);
  bool is_cut = false;
  for (std::size_t j = 0; j < jumps_.size(); ++j)
    if (const Cut& other = cuts_[jumps_[j]]; other.block == last.block)
      is_cut = block.divide(JumpId{j}, other.start, other.end, smallest_);
  if (!is_cut) divided_.erase(last.block);
}

std::vector<BlockId> CrackGeometry::blocks_near(const Vec2& x) const {
  std::vector<BlockId> out;
  grid_.for_each_hit(Box{x, x}, [&](std::size_t b) {
    if (contains(assembly_.blocks[b].outline, x, tolerance())) out.push_back(BlockId{b});
  });
  std::ranges::sort(out);
  return out;
}

std::optional<BlockId> CrackGeometry::block_ahead(const Vec2& tip, const Vec2& direction) const {
  for (const BlockId block : blocks_near(tip)) {
    const auto cut = divided_.find(block);
    if (cut == divided_.end() ? enters(assembly_.blocks[block.value()].outline, tip, direction, tolerance())
                              : !cut->second.is_on_cut(tip, tolerance()) &&
                                    std::ranges::any_of(cut->second.parts(), [&](const Part& part) {
                                      return enters(part.outline, tip, direction, tolerance());
                                    }))
      return block;
  }
  return {};
}

std::optional<Vec2> CrackGeometry::exit(BlockId block, const Vec2& tip, const Vec2& direction) const {
  const auto of = [&](const Polygon& outline) -> std::optional<Vec2> {
    if (!enters(outline, tip, direction, tolerance())) return {};
    return exit_of(outline, tip, direction, tolerance());
  };
  const auto cut = divided_.find(block);
  if (cut == divided_.end()) return of(assembly_.blocks[block.value()].outline);
  for (const Part& part : cut->second.parts())
    if (const auto found = of(part.outline)) return found;
  return {};
}

bool CrackGeometry::is_on_crack(const Vec2& x, int crack) const {
  return std::ranges::any_of(cuts_, [&](const Cut& cut) {
    if (distance(x, cut.start, cut.end) > tolerance()) return false;
    return cut.crack != crack || is_between(x, cut.start, cut.end);
  });
}

std::vector<std::size_t> CrackGeometry::sides_at(const Vec2& x) const {
  std::vector<std::size_t> out;
  for (const BlockId block : blocks_near(x))
    for (const std::size_t s : sides_of_[block.value()])
      if (distance(x, assembly_.sides[s].start, assembly_.sides[s].end) <= tolerance()) out.push_back(s);
  std::ranges::sort(out);
  const auto [first, last] = std::ranges::unique(out);
  out.erase(first, last);
  return out;
}

std::optional<CrackGeometry::Way> CrackGeometry::way_along(const Vec2& tip, const Vec2& direction) const {
  std::optional<Way> out;
  for (const std::size_t s : sides_at(tip))
    for (const Vec2& end : {assembly_.sides[s].start, assembly_.sides[s].end}) {
      if ((end - tip).norm() <= tolerance() || is_open(s, (tip + end) / 2)) continue;
      const double angle = std::abs(std::atan2(cross(direction, end - tip), direction.dot(end - tip)));
      if (!out || angle < out->angle) out = Way{s, end, angle};
    }
  return out;
}

std::optional<std::size_t> CrackGeometry::cut_along(std::size_t side, const Vec2& x) const {
  if (!on_sides_.contains(side)) return {};
  for (std::size_t c = 0; c < cuts_.size(); ++c)
    if (cuts_[c].side == side && is_between(x, cuts_[c].start, cuts_[c].end)) return c;
  return {};
}

bool CrackGeometry::is_open(std::size_t side, const Vec2& x) const { return cut_along(side, x).has_value(); }

std::span<const Part> CrackGeometry::parts(BlockId block) const {
  const auto cut = divided_.find(block);
  return cut == divided_.end() ? std::span<const Part>() : std::span<const Part>(cut->second.parts());
}

std::span<const JumpId> CrackGeometry::jumps_at(BlockId block, const Vec2& x) const {
  const auto cut = divided_.find(block);
  return cut == divided_.end() ? std::span<const JumpId>()
                               : std::span<const JumpId>(cut->second.part_at(x).jumps);
}

CrackGeometry::Beside CrackGeometry::beside(const Cut& cut, const Vec2& x) const {
  const DividedBlock& block = divided_.at(cut.block);
  const Vec2 along = cut.end - cut.start;
  return {block.beside(x, -along).jumps, block.beside(x, along).jumps};
}

CrackGeometry::Across CrackGeometry::across(const Cut& cut, const Vec2& x) const {
  const auto without = [](std::span<const JumpId> all, std::span<const JumpId> others) {
    std::vector<JumpId> out;
    std::ranges::copy_if(all, std::back_inserter(out),
                         [&](JumpId jump) { return std::ranges::find(others, jump) == others.end(); });
    return out;
  };
  const Beside at = beside(cut, x);
  return {without(at.right, at.left), without(at.left, at.right)};
}

std::vector<std::pair<Vec2, Vec2>> CrackGeometry::pieces_of_cut(const Cut& cut) const {
  std::vector<Vec2> at{cut.start};
  for (const Cut& other : cuts_)
    if (other.block == cut.block && !other.side && is_between(other.end, cut.start, cut.end))
      at.push_back(other.end);
  const Vec2 along = cut.end - cut.start;
  std::ranges::stable_sort(at, {}, [&](const Vec2& x) { return along.dot(x); });
  at.push_back(cut.end);
  std::vector<std::pair<Vec2, Vec2>> out;
  for (std::size_t i = 0; i + 1 < at.size(); ++i)
    if ((at[i + 1] - at[i]).norm() > tolerance() || at.size() == 2) out.emplace_back(at[i], at[i + 1]);
  return out;
}

bool CrackGeometry::is_touched(std::size_t side) const {
  if (empty()) return false;
  const Side& at = assembly_.sides[side];
  return on_sides_.contains(side) || divided_.contains(at.first) || divided_.contains(at.second);
}

std::vector<std::size_t> CrackGeometry::touched_sides() const {
  std::vector<std::size_t> out;
  for (std::size_t s = 0; s < assembly_.sides.size() && !empty(); ++s)
    if (is_touched(s)) out.push_back(s);
  return out;
}

/// Ends of the pieces, in their order; marks closer to each other than the tolerance are one.
std::vector<Vec2> CrackGeometry::stations(const Marks& marks, std::size_t side, const Vec2& start,
                                          const Vec2& end) const {
  std::vector<Vec2> all{start};
  if (const auto found = marks.find(side); found != marks.end())
    for (const Mark& mark : found->second) all.push_back(mark.at);
  const Vec2 along = end - start;
  std::ranges::stable_sort(all, {}, [&](const Vec2& x) { return along.dot(x - start); });
  std::vector<Vec2> out;
  for (const Vec2& x : all)
    if ((x - end).norm() > tolerance() && (out.empty() || (x - out.back()).norm() > tolerance()))
      out.push_back(x);
  out.push_back(end);
  return out;
}

std::vector<SidePiece> CrackGeometry::pieces_of_side(std::size_t side) const {
  const Side& whole = assembly_.sides[side];
  const std::vector<Vec2> at = stations(on_sides_, side, whole.start, whole.end);
  const auto jumps = [&](BlockId block, const Vec2& x) {
    const auto found = jumps_at(block, x);
    return std::vector<JumpId>(found.begin(), found.end());
  };
  std::vector<SidePiece> out;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Vec2 middle = (at[i] + at[i + 1]) / 2;
    out.push_back(
        {at[i], at[i + 1], jumps(whole.first, middle), jumps(whole.second, middle), cut_along(side, middle)});
  }
  return out;
}

std::vector<BoundaryPiece> CrackGeometry::pieces_of_boundary(std::size_t boundary_side) const {
  const BoundarySide& whole = assembly_.boundary[boundary_side];
  const std::vector<Vec2> at = stations(on_boundary_, boundary_side, whole.start, whole.end);
  std::vector<BoundaryPiece> out;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const auto jumps = jumps_at(whole.block, (at[i] + at[i + 1]) / 2);
    out.push_back({at[i], at[i + 1], {jumps.begin(), jumps.end()}});
  }
  return out;
}

}  // namespace dda
