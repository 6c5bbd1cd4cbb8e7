#include "continuation/bodies/meetings.hpp"

#include <algorithm>
#include <numeric>
#include <span>

#include "framework/base/threads.hpp"
#include "meshing/contact/free_way.hpp"
#include "meshing/contact/narrow.hpp"
#include "meshing/geometry/polygon.hpp"

namespace dda {
namespace {

/// The vertices at a pose, or what a difference of poses is at them.
std::vector<Vec2> placed(const MovingBody& body, const Pose& y) {
  std::vector<Vec2> out;
  out.reserve(body.core.size());
  for (const Vec2& x : body.core) out.push_back(place_of(y, x));
  return out;
}

Box box_of(const MovingBody& body, const Pose& y) {
  Box out;
  for (const Vec2& x : body.core) out.include(place_of(y, x));
  return out;
}

/// The box of all places of a body on its way.
struct Swept {
  Box box;
  std::uint32_t body = 0;
};

bool segments_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

bool cores_cross(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  for (std::size_t p = 0; p < a.size(); ++p)
    for (std::size_t q = 0; q < b.size(); ++q)
      if (segments_cross(a[p], a[(p + 1) % a.size()], b[q], b[(q + 1) % b.size()])) return true;
  return contains(Polygon{a}, b.front(), 0) || contains(Polygon{b}, a.front(), 0);
}

/// The place in the undeformed body of what is at a share of an edge.
Vec2 material_point(const std::vector<Vec2>& core, std::span<const Vec2> now, const Facing& facing) {
  const Vec2 &a = core[facing.edge], &b = core[(facing.edge + 1) % core.size()];
  if (facing.is_corner) return a;
  const Vec2 edge = now[(facing.edge + 1) % now.size()] - now[facing.edge];
  return a + (facing.foot - now[facing.edge]).dot(edge) / edge.squaredNorm() * (b - a);
}

}  // namespace

MeetingSearch::MeetingSearch(const MovingScene& scene, std::vector<Pair> joined)
    : scene_(scene), joined_(std::move(joined)) {
  for (auto& [a, b] : joined_)
    if (a > b) std::swap(a, b);
  std::ranges::sort(joined_);
  joined_.erase(std::ranges::unique(joined_).begin(), joined_.end());
}

std::vector<MeetingSearch::Pair> MeetingSearch::candidates(const Poses& from, const Poses& to,
                                                           double reach) const {
  const auto n = static_cast<std::uint32_t>(scene_.num_bodies());
  std::vector<Swept> swept(n);
  parallel_for(n, 256, [&](std::size_t i) {
    Box box = box_of(scene_.bodies[i], from[i]);
    const Box then = box_of(scene_.bodies[i], to[i]);
    box.include(then.low);
    box.include(then.high);
    swept[i] = {box.inflated(reach / 2), static_cast<std::uint32_t>(i)};
  });
  std::ranges::sort(swept, {}, [](const Swept& one) { return std::pair(one.box.low.x(), one.body); });
  std::vector<Pair> out;
  for (auto one = swept.begin(); one != swept.end(); ++one)
    for (auto other = one + 1; other != swept.end() && other->box.low.x() <= one->box.high.x(); ++other) {
      if (other->box.low.y() > one->box.high.y() || other->box.high.y() < one->box.low.y()) continue;
      const Pair pair = std::minmax(one->body, other->body);
      if (scene_.bodies[pair.first].is_held && scene_.bodies[pair.second].is_held) continue;
      if (!std::ranges::binary_search(joined_, pair)) out.push_back(pair);
    }
  std::ranges::sort(out);
  return out;
}

/// Outlines of cores at some poses, one after another, and their boxes.
class MeetingSearch::Placed {
 public:
  Placed(const MovingScene& scene, const Poses& at) {
    first_.reserve(scene.num_bodies() + 1);
    for (std::size_t b = 0; b < scene.num_bodies(); ++b) {
      first_.push_back(points_.size());
      Box& box = boxes_.emplace_back();
      for (const Vec2& x : scene.bodies[b].core) {
        points_.push_back(place_of(at[b], x));
        box.low = box.low.cwiseMin(points_.back());
        box.high = box.high.cwiseMax(points_.back());
      }
    }
    first_.push_back(points_.size());
  }
  std::span<const Vec2> outline(std::size_t b) const {
    return std::span(points_).subspan(first_[b], first_[b + 1] - first_[b]);
  }
  const Box& box(std::size_t b) const { return boxes_[b]; }

 private:
  std::vector<Vec2> points_;
  std::vector<std::size_t> first_;
  std::vector<Box> boxes_;
};

/// The vertices of the first of a pair that meet the second.
void MeetingSearch::meet(const Pair& pair, const Placed& placed, double reach,
                         std::vector<Meeting>& out) const {
  const auto [i, j] = pair;
  const Vec2 low = placed.box(j).low.array() - reach, high = placed.box(j).high.array() + reach;
  if ((placed.box(i).low.array() > high.array()).any() || (placed.box(i).high.array() < low.array()).any())
    return;
  const MovingBody &one = scene_.bodies[i], &other = scene_.bodies[j];
  const double modulus = 2 * one.modulus * other.modulus / (one.modulus + other.modulus);
  const double k = scene_.meeting.stiffness * modulus * scene_.thickness / 2;
  const std::span<const Vec2> vertices = placed.outline(i), outline = placed.outline(j);
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    const Vec2& x = vertices[v];
    if ((x.array() < low.array()).any() || (x.array() > high.array()).any()) continue;
    for_each_facing(x, outline, reach, [&](const Facing& facing) {
      out.push_back({{i, v, j, static_cast<std::uint32_t>(facing.edge), facing.is_corner},
                     one.core[v],
                     material_point(other.core, outline, facing),
                     (x - facing.foot) / facing.distance,
                     facing.distance,
                     k});
    });
  }
}

std::vector<Meeting> MeetingSearch::find(const std::vector<Pair>& pairs, const Poses& at,
                                         double reach) const {
  constexpr std::size_t pairs_at_once = 512;
  const Placed placed(scene_, at);
  std::vector<std::vector<Meeting>> found((pairs.size() + pairs_at_once - 1) / pairs_at_once);
  parallel_pieces(pairs.size(), pairs_at_once, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      meet(pairs[p], placed, reach, found[begin / pairs_at_once]);
      meet({pairs[p].second, pairs[p].first}, placed, reach, found[begin / pairs_at_once]);
    }
  });
  if (found.size() == 1) return std::move(found.front());
  std::vector<Meeting> out;
  for (const auto& some : found) out.insert(out.end(), some.begin(), some.end());
  return out;
}

double MeetingSearch::free_share(const std::vector<Pair>& pairs, const Poses& z, const Poses& dz) const {
  constexpr double kept = 0.2;
  constexpr std::size_t pairs_at_once = 128;
  const Placed places(scene_, z), ways(scene_, dz);
  std::vector<double> free(pairs.size(), 1.0);
  parallel_for(pairs.size(), pairs_at_once, [&](std::size_t p) {
    const auto [i, j] = pairs[p];
    free[p] = free_way({places.outline(i), ways.outline(i)}, {places.outline(j), ways.outline(j)}, kept, 1.0);
  });
  double out = 1;
  for (const double share : free) out = std::min(out, share);
  return out;
}

std::optional<MeetingSearch::Pair> MeetingSearch::crossing(const Poses& at) const {
  for (const Pair& pair : candidates(at, at))
    if (cores_cross(placed(scene_.bodies[pair.first], at[pair.first]),
                    placed(scene_.bodies[pair.second], at[pair.second])))
      return pair;
  return {};
}

bool MeetingSearch::are_apart(const Pair& pair, const Poses& at, double least) const {
  constexpr double hardly = 1e-3;
  const double near = (1 - hardly) * least;
  const std::vector<Vec2> a = placed(scene_.bodies[pair.first], at[pair.first]),
                          b = placed(scene_.bodies[pair.second], at[pair.second]);
  if (!bounding_box(a).inflated(near).touches(bounding_box(b))) return true;
  const auto is_near = [near](const Vec2& x, const std::vector<Vec2>& outline) {
    for (std::size_t e = 0; e < outline.size(); ++e)
      if (distance(x, outline[e], outline[(e + 1) % outline.size()]) < near) return true;
    return false;
  };
  return !cores_cross(a, b) && std::ranges::none_of(a, [&](const Vec2& x) { return is_near(x, b); }) &&
         std::ranges::none_of(b, [&](const Vec2& x) { return is_near(x, a); });
}

}  // namespace dda
