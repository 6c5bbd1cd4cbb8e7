#include "models/body/place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "framework/base/suggestion.hpp"
#include "models/body/motion.hpp"

namespace dda {
namespace {

/// How far outside its block a point of the deck may lie: round-off of its coordinates [L].
double tolerance(const Assembly& assembly) {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Block& block : assembly.blocks)
    for (const Vec2& v : block.outline.vertices) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
  return 1e-7 * (high - low).norm();
}

std::string text(const Vec2& x) { return fmt::format("({:g}, {:g})", x.x(), x.y()); }

void add_gauss_points(const BlockId block, const Vec2& start, const Vec2& end,
                      std::vector<BoundaryPoint>& out) {
  const Vec2 edge = end - start;
  const Vec2 normal = Vec2(edge.y(), -edge.x()) / edge.norm();
  for (const double xi : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)})
    out.push_back({block, start + xi * edge, normal, 0.5 * edge.norm()});
}

double length_of(const std::vector<BoundaryPoint>& points) {
  double sum = 0;
  for (const BoundaryPoint& point : points) sum += point.length;
  return sum;
}

/// Calls visit(side) for each side of the boundary, in pieces where cuts end on it.
template <class Visit>
void for_each_piece(const Body& body, Visit visit) {
  const auto& boundary = body.assembly.boundary;
  for (std::size_t s = 0; s < boundary.size(); ++s) {
    if (body.num_jumps() == 0) {
      visit(boundary[s]);
      continue;
    }
    BoundarySide part = boundary[s];
    for (const BoundaryPiece& piece : body.cracks->pieces_of_boundary(s)) {
      part.start = piece.start;
      part.end = piece.end;
      visit(part);
    }
  }
}

/// Σ weight · direction·u over the points of a patch; the rows of a node are one.
class PatchSum {
 public:
  explicit PatchSum(const Body& body) : body_(body) {}
  void add(double weight, const BoundaryPoint& point, const Vec2& direction) {
    for (const auto& [node, rows] : motions_at(body_, point.block, point.x)) {
      const Vec6 row = weight * rows.transpose() * direction;
      const auto known = std::ranges::find(sum_.rows, node, &std::pair<BlockId, Vec6>::first);
      if (known != sum_.rows.end())
        known->second += row;
      else
        sum_.rows.emplace_back(node, row);
    }
  }
  Functional sum() const { return sum_; }

 private:
  const Body& body_;
  Functional sum_;
};

/// The straight line between the ends of `over`.
struct Line {
  Vec2 from, to;
  double length() const { return (to - from).norm(); }
  Vec2 tangent() const { return (to - from) / length(); }
};

Line line_of(const Assembly& assembly, const Place& place) {
  return {locate(assembly, place.over->front()), locate(assembly, place.over->back())};
}

/// Points of the piece that a side has in common with the line, if it lies on it.
void add_common_piece(const BoundarySide& side, const Line& line, double tol,
                      std::vector<BoundaryPoint>& out) {
  const Vec2 t = line.tangent();
  if (std::abs(cross(t, side.start - line.from)) > tol || std::abs(cross(t, side.end - line.from)) > tol)
    return;
  const double length = line.length(), start = t.dot(side.start - line.from),
               end = t.dot(side.end - line.from);
  const double first = std::clamp(start, 0.0, length), last = std::clamp(end, 0.0, length);
  if (std::abs(last - first) > tol)
    add_gauss_points(side.block, line.from + first * t, line.from + last * t, out);
}

int boundary_index(const Assembly& assembly, const std::string& name, const Position& where) {
  const auto known = std::ranges::find(assembly.boundaries, name);
  if (known == assembly.boundaries.end())
    throw InputError(where, fmt::format("unknown boundary '{}'{}", name, suggest(name, assembly.boundaries)));
  const auto index = static_cast<int>(known - assembly.boundaries.begin());
  if (std::ranges::none_of(assembly.boundary,
                           [index](const BoundarySide& side) { return side.boundary == index; }))
    throw InputError(
        where,
        fmt::format(
            "boundary '{}' has no side of its own: each is on a plane of symmetry, which nothing else may "
            "hold or load, or on a boundary that is listed before it; name that one",
            name));
  return index;
}

}  // namespace

Vec2 locate(const Assembly& assembly, const Spot& spot) {
  if (spot.name.empty()) return spot.x;
  if (const auto found = assembly.points.find(spot.name); found != assembly.points.end())
    return found->second;
  std::vector<std::string> names;
  for (const auto& [name, x] : assembly.points) names.push_back(name);
  throw InputError(
      spot.where,
      names.empty() ? fmt::format("unknown point '{}': the scene names no points; give [x, y], or add it to "
                                  "`scene.points`",
                                  spot.name)
                    : fmt::format("unknown point '{}'{}", spot.name, suggest(spot.name, names)));
}

std::vector<BlockId> blocks_of(const Assembly& assembly, const Place& place, const Position& where) {
  const double tol = tolerance(assembly);
  const Vec2 at = locate(assembly, *place.at);
  auto found = blocks_at(assembly, at, tol);
  if (found.empty())
    throw InputError(
        where, fmt::format("the point {} lies outside every block; move it onto the structure", text(at)));
  if (!place.inside) return found;
  const Vec2 inside = locate(assembly, *place.inside);
  const auto chosen = blocks_at(assembly, inside, tol);
  std::erase_if(found, [&](BlockId id) { return std::ranges::find(chosen, id) == chosen.end(); });
  if (found.empty())
    throw InputError(where,
                     fmt::format("no block contains both `at` {} and `inside` {}; move `inside` closer "
                                 "to `at`, into the block that is meant",
                                 text(at), text(inside)));
  return found;
}

Functional displacement_at(const Body& body, const Place& place, const Vec2& direction,
                           const Position& where) {
  if (place.over) {
    const auto points = patch_points(body, place, where);
    const double length = length_of(points);
    PatchSum mean(body);
    for (const BoundaryPoint& point : points) mean.add(point.length / length, point, direction);
    return mean.sum();
  }
  Functional out;
  const Vec2 at = locate(body.assembly, *place.at);
  const auto blocks = blocks_of(body.assembly, place, where);
  for (const BlockId id : blocks)
    for (const auto& [node, rows] : motions_at(body, id, at))
      out.rows.emplace_back(node, rows.transpose() * direction / static_cast<double>(blocks.size()));
  return out;
}

Functional rotation_over(const Body& body, const Place& place, const Position& where) {
  const auto points = patch_points(body, place, where);
  const Line line = line_of(body.assembly, place);
  const Vec2 t = line.tangent(), normal(-t.y(), t.x()), middle = (line.from + line.to) / 2;
  PatchSum mean(body);
  for (const BoundaryPoint& point : points)
    mean.add(12 * point.length * t.dot(point.x - middle) / std::pow(line.length(), 3), point, normal);
  return mean.sum();
}

std::vector<PartOfPatch> departures_over(const Body& body, const Place& place, const Position& where) {
  const auto points = patch_points(body, place, where);
  constexpr std::size_t most = 400;
  if (points.size() > most)
    throw InputError(where,
                     fmt::format("`fix: straight` ties each of the {} points of the patch to all others; "
                                 "at most {}: take larger blocks there",
                                 points.size(), most));
  const Line line = line_of(body.assembly, place);
  const Vec2 t = line.tangent(), normal(-t.y(), t.x()), middle = (line.from + line.to) / 2;
  const auto along = [&](const BoundaryPoint& point) { return t.dot(point.x - middle) / line.length(); };
  std::vector<PartOfPatch> out;
  for (const BoundaryPoint& one : points) {
    PatchSum departure(body);
    departure.add(1, one, normal);
    for (const BoundaryPoint& other : points)
      departure.add(-other.length / line.length() * (1 + 12 * along(one) * along(other)), other, normal);
    out.emplace_back(departure.sum(), one.length);
  }
  return out;
}

std::vector<BoundaryPoint> boundary_points(const Body& body, const std::string& name, const Position& where) {
  const int index = boundary_index(body.assembly, name, where);
  std::vector<BoundaryPoint> points;
  for_each_piece(body, [&](const BoundarySide& side) {
    if (side.boundary == index) add_gauss_points(side.block, side.start, side.end, points);
  });
  return points;
}

std::vector<BoundaryPoint> held_points(const Body& body, const std::string& name, const Position& where) {
  const int index = boundary_index(body.assembly, name, where);
  std::vector<BoundaryPoint> points;
  for (const BoundarySide& side : body.assembly.boundary)
    if (side.boundary == index) add_gauss_points(side.block, side.start, side.end, points);
  return points;
}

std::vector<BoundaryPoint> patch_points(const Body& body, const Place& place, const Position& where) {
  const Assembly& assembly = body.assembly;
  const Line line = line_of(assembly, place);
  const double tol = tolerance(assembly);
  const std::string name = fmt::format("the patch from {} to {}", text(line.from), text(line.to));
  if (line.length() <= tol) throw InputError(where, name + " has no length");
  std::vector<BoundaryPoint> points;
  for_each_piece(body, [&](const BoundarySide& side) { add_common_piece(side, line, tol, points); });
  if (place.inside) {
    const Vec2 inside = locate(assembly, *place.inside) - line.from;
    std::erase_if(points, [&](const BoundaryPoint& point) { return point.normal.dot(inside) >= 0; });
  }
  const double covered = length_of(points) / line.length();
  constexpr double slack = 1e-5;
  if (covered < 1 - slack)
    throw InputError(where,
                     fmt::format("only {:.3g} % of {} lie on outer sides of blocks; both ends must lie "
                                 "on one straight piece of the boundary",
                                 100 * covered, name));
  if (covered > 1 + slack)
    throw InputError(where,
                     name + " lies on two boundaries; give `inside`, a point on the side that is meant");
  return points;
}

}  // namespace dda
