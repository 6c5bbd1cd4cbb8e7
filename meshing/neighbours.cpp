#include "meshing/neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "meshing/geometry/box_grid.hpp"

namespace dda {
namespace {

constexpr double relative_tolerance = 1e-9;  // of the scene's size: how far collinear edges may lie apart
constexpr double shortest_piece = 1e-6;      // of the edge
constexpr std::size_t nothing = std::numeric_limits<std::size_t>::max();

struct Edge {
  std::size_t block = 0;
  Vec2 start, end, tangent;
  double length = 0;
};

/// A part [from, to] of an edge, by distance from its start; `what` is a block or a line piece.
struct Stretch {
  double from = 0, to = 0;
  std::size_t what = nothing;
};

Edge edge_between(std::size_t block, const Vec2& start, const Vec2& end) {
  const double length = (end - start).norm();
  return {block, start, end, length > 0 ? Vec2((end - start) / length) : Vec2::Zero(), length};
}

/// All edges, in order, relative to the scene's centre so that a far-away scene loses no digits.
std::vector<Edge> edges_of(const std::vector<Block>& blocks, const Vec2& centre) {
  std::vector<Edge> edges;
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (std::size_t i = 0; i < blocks[b].outline.size(); ++i)
      edges.push_back(
          edge_between(b, blocks[b].outline.at(i) - centre, blocks[b].outline.at(i + 1) - centre));
  return edges;
}

Box scene_box(const std::vector<Block>& blocks) {
  Box box;
  for (const Block& block : blocks)
    for (const Vec2& x : block.outline.vertices) box.include(x);
  return box;
}

bool on_line(const Edge& edge, const Vec2& x, double tolerance) {
  return std::abs(cross(edge.tangent, x - edge.start)) <= tolerance;
}

/// The stretch of `edge` covered by the segment from a to b, empty unless they are collinear. Whichever of
/// the two is shorter is measured from the line of the longer one, which is the better known direction.
Stretch common_stretch(const Edge& edge, const Edge& other, double tolerance) {
  const Edge &longer = edge.length >= other.length ? edge : other, &shorter = &longer == &edge ? other : edge;
  if (!on_line(longer, shorter.start, tolerance) || !on_line(longer, shorter.end, tolerance)) return {};
  const double a = (other.start - edge.start).dot(edge.tangent),
               b = (other.end - edge.start).dot(edge.tangent);
  Stretch common{std::max(0.0, std::min(a, b)), std::min(edge.length, std::max(a, b)), nothing};
  if (common.to - common.from < shortest_piece * shorter.length) return {};
  // Ends within the tolerance of a corner are the corner, so that no sliver is left over.
  if (common.from <= tolerance) common.from = 0;
  if (common.to >= edge.length - tolerance) common.to = edge.length;
  return common;
}

std::vector<Box> boxes_of(const std::vector<Edge>& edges, double tolerance) {
  std::vector<Box> boxes;
  boxes.reserve(edges.size());
  for (const Edge& edge : edges) boxes.push_back(bounding_box({edge.start, edge.end}).inflated(tolerance));
  return boxes;
}

/// The finder's working memory: for each edge the blocks it touches and the named lines it lies on.
class Finder {
 public:
  Finder(const std::vector<Block>& blocks, const std::vector<LinePiece>& lines);
  Neighbours result() &&;

 private:
  void match_edges(const BoxGrid& grid);
  void match_lines(const BoxGrid& grid);
  void split(std::size_t e);
  void place(std::size_t e, const Stretch& part);
  std::optional<int> name_on(std::size_t e, const Stretch& part, LineRole role) const;
  std::size_t touching(std::size_t e, double middle) const;
  std::vector<double> breaks(std::size_t e) const;
  Vec2 point(std::size_t e, double s) const;
  void add_side(std::size_t e, const Stretch& part);
  void add_boundary(std::size_t e, const Stretch& part);

  const std::vector<LinePiece>& lines_;
  Box box_;
  double tolerance_;
  std::vector<Edge> edges_;
  std::vector<std::vector<Stretch>> touches_, marks_;
  Neighbours found_;
};

Finder::Finder(const std::vector<Block>& blocks, const std::vector<LinePiece>& lines)
    : lines_(lines),
      box_(scene_box(blocks)),
      tolerance_(relative_tolerance * box_.size()),
      edges_(edges_of(blocks, box_.centre())),
      touches_(edges_.size()),
      marks_(edges_.size()) {
  found_.used.assign(lines.size(), false);
  const BoxGrid grid(boxes_of(edges_, tolerance_));
  match_edges(grid);
  match_lines(grid);
}

void Finder::match_edges(const BoxGrid& grid) {
  grid.for_each_pair([&](std::size_t i, std::size_t j) {
    const Edge &a = edges_[i], &b = edges_[j];
    if (a.block == b.block || a.tangent.dot(b.tangent) >= 0) return;
    Stretch on_a = common_stretch(a, b, tolerance_), on_b = common_stretch(b, a, tolerance_);
    if (on_a.to <= on_a.from || on_b.to <= on_b.from) return;
    on_a.what = b.block;
    on_b.what = a.block;
    touches_[i].push_back(on_a);
    touches_[j].push_back(on_b);
  });
}

void Finder::match_lines(const BoxGrid& grid) {
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    const Edge line = edge_between(k, lines_[k].start - box_.centre(), lines_[k].end - box_.centre());
    grid.for_each_hit(bounding_box({line.start, line.end}).inflated(tolerance_), [&](std::size_t e) {
      Stretch mark = common_stretch(edges_[e], line, tolerance_);
      if (mark.to <= mark.from) return;
      mark.what = k;
      marks_[e].push_back(mark);
      found_.used[k] = true;
    });
  }
}

/// Where anything begins or ends along the edge, ascending, nothing closer than the shortest piece.
std::vector<double> Finder::breaks(std::size_t e) const {
  const double length = edges_[e].length;
  std::vector<double> all{0, length}, kept;
  for (const auto* stretches : {&touches_[e], &marks_[e]})
    for (const Stretch& s : *stretches) all.insert(all.end(), {s.from, s.to});
  std::sort(all.begin(), all.end());
  for (const double s : all)
    if (kept.empty() || s - kept.back() > shortest_piece * length) kept.push_back(s);
  kept.back() = length;
  return kept;
}

std::size_t Finder::touching(std::size_t e, double middle) const {
  std::size_t lowest = nothing;
  for (const Stretch& s : touches_[e])
    if (s.from < middle && middle < s.to) lowest = std::min(lowest, s.what);
  return lowest;
}

/// Name of the first listed line of that role under the part, if any.
std::optional<int> Finder::name_on(std::size_t e, const Stretch& part, LineRole role) const {
  const double middle = (part.from + part.to) / 2;
  std::size_t first = nothing;
  for (const Stretch& s : marks_[e])
    if (s.from < middle && middle < s.to && lines_[s.what].role == role) first = std::min(first, s.what);
  return first == nothing ? std::nullopt : std::optional(lines_[first].name);
}

Vec2 Finder::point(std::size_t e, double s) const {
  const Edge& edge = edges_[e];
  const Vec2 x = s <= 0 ? edge.start : s >= edge.length ? edge.end : Vec2(edge.start + s * edge.tangent);
  return x + box_.centre();
}

void Finder::add_side(std::size_t e, const Stretch& part) {
  // The piece comes up on both blocks; the lower number keeps it.
  if (edges_[e].block > part.what) return;
  found_.sides.push_back({BlockId{edges_[e].block}, BlockId{part.what}, point(e, part.from),
                          point(e, part.to), name_on(e, part, LineRole::interface)});
}

void Finder::add_boundary(std::size_t e, const Stretch& part) {
  found_.boundary.push_back({BlockId{edges_[e].block}, point(e, part.from), point(e, part.to),
                             name_on(e, part, LineRole::boundary)});
}

void Finder::place(std::size_t e, const Stretch& part) {
  if (part.what == nothing || name_on(e, part, LineRole::slit))
    add_boundary(e, part);
  else
    add_side(e, part);
}

/// Cuts the edge at every break and joins again what has the same neighbour and the same names.
void Finder::split(std::size_t e) {
  const std::vector<double> at = breaks(e);
  const auto names = [&](const Stretch& s) {
    return std::tuple{s.what, name_on(e, s, LineRole::slit), name_on(e, s, LineRole::interface),
                      name_on(e, s, LineRole::boundary)};
  };
  Stretch open{at[0], at[0], nothing};
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Stretch next{at[i], at[i + 1], touching(e, (at[i] + at[i + 1]) / 2)};
    const bool same = i > 0 && names(open) == names(next);
    if (!same && i > 0) place(e, open);
    open = {same ? open.from : next.from, next.to, next.what};
  }
  if (open.to > open.from) place(e, open);
}

Neighbours Finder::result() && {
  for (std::size_t e = 0; e < edges_.size(); ++e) split(e);
  return std::move(found_);
}

}  // namespace

Neighbours find_neighbours(const std::vector<Block>& blocks, const std::vector<LinePiece>& lines) {
  return Finder(blocks, lines).result();
}

}  // namespace dda
