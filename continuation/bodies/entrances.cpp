#include "continuation/bodies/entrances.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace dda {
namespace {

/// The outline of a body where it is.
class Outline {
 public:
  Outline(const MovingBody& body, std::uint32_t id, const Pose& y) : id_(id), material_(body.outline) {
    for (const Vec2& x : body.outline) points_.push_back(place_of(y, x));
    for (std::uint32_t e = 0; e < size(); ++e) along_.push_back((point(e + 1) - point(e)).normalized());
  }

  std::uint32_t id() const { return id_; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  std::uint32_t before(std::uint32_t i) const { return (i + size() - 1) % size(); }
  const Vec2& point(std::uint32_t i) const { return points_[i % size()]; }
  const Vec2& material(std::uint32_t i) const { return material_[i % size()]; }
  const Vec2& along(std::uint32_t edge) const { return along_[edge]; }
  Vec2 normal(std::uint32_t edge) const { return {along_[edge].y(), -along_[edge].x()}; }
  bool is_convex(std::uint32_t corner) const { return turn(corner) > flat; }
  bool is_notch(std::uint32_t corner) const { return turn(corner) < -flat; }

 private:
  static constexpr double flat = 1e-6;

  double turn(std::uint32_t corner) const { return cross(along_[before(corner)], along_[corner]); }

  std::uint32_t id_;
  const std::vector<Vec2>& material_;
  std::vector<Vec2> points_, along_;
};

/// How a corner stands before an edge.
struct Stand {
  double share;  ///< of the foot along the edge
  double gap;    ///< [L]
};

/// Finds what meets of two bodies.
class Pairing {
 public:
  Pairing(const Outline& one, const Outline& other, double reach, std::vector<Meeting>& out)
      : outlines_{&one, &other}, reach_(reach), out_(out) {}

  void find() {
    for (std::uint32_t p = 0; p < outlines_[0]->size(); ++p)
      for (std::uint32_t q = 0; q < outlines_[1]->size(); ++q)
        if ((outlines_[0]->point(p) - outlines_[1]->point(q)).norm() < reach_) meet_corners(p, q);
    for (const int side : {0, 1}) meet_edges(side);
  }

 private:
  /// A corner of the body `side` at an edge of the other.
  struct Candidate {
    int side;
    std::uint32_t corner, edge;
    Stand stand;

    double beside() const { return std::max({0.0, -stand.share, stand.share - 1}); }
  };

  const Outline& of(int side) const { return *outlines_[static_cast<std::size_t>(side)]; }

  std::optional<Candidate> candidate(int side, std::uint32_t corner, std::uint32_t edge) const {
    constexpr double parallel = 0.0523;  // sin 3°
    const Outline &own = of(side), &other = of(1 - side);
    const Vec2 n = other.normal(edge);
    if (!own.is_convex(corner) || own.along(corner).dot(n) < -parallel ||
        own.along(own.before(corner)).dot(n) > parallel)
      return {};
    const Vec2 to = own.point(corner) - other.point(edge), whole = other.point(edge + 1) - other.point(edge);
    return Candidate{side, corner, edge, {to.dot(whole) / whole.squaredNorm(), to.dot(n)}};
  }

  /// Convex corners near each other: the edge before which they are farthest apart.
  void meet_corners(std::uint32_t p, std::uint32_t q) {
    const Outline &one = of(0), &other = of(1);
    if (!one.is_convex(p) || !other.is_convex(q)) return;
    const double same = 1e-9 * reach_;
    std::optional<Candidate> best;
    const auto ask = [&](const Candidate& next) {
      if (!best || next.stand.gap > best->stand.gap + same ||
          (next.stand.gap > best->stand.gap - same && next.beside() < best->beside()))
        best = next;
    };
    for (const std::uint32_t edge : {other.before(q), q}) {
      near_.insert({0, p, edge});
      if (const auto next = candidate(0, p, edge)) ask(*next);
    }
    for (const std::uint32_t edge : {one.before(p), p}) {
      near_.insert({1, q, edge});
      if (const auto next = candidate(1, q, edge)) ask(*next);
    }
    if (best) add(*best, true);
  }

  /// Whether the foot is on the edge, or behind an end of it that is a notch: a corner that has gone in there has its
  /// feet beyond both edges.
  bool has_foot(const Candidate& at) const {
    const Outline& other = of(1 - at.side);
    const double beyond = at.beside() * (other.point(at.edge + 1) - other.point(at.edge)).norm();
    const std::uint32_t end = at.stand.share < 0 ? at.edge : (at.edge + 1) % other.size();
    return beyond == 0 || (beyond < reach_ && other.is_notch(end));
  }

  void meet_edges(int side) {
    for (std::uint32_t p = 0; p < of(side).size(); ++p)
      for (std::uint32_t e = 0; e < of(1 - side).size(); ++e) {
        if (near_.contains({side, p, e})) continue;
        const auto next = candidate(side, p, e);
        if (next && std::abs(next->stand.gap) < reach_ && has_foot(*next)) add(*next, false);
      }
  }

  void add(const Candidate& at, bool is_corner) {
    const Outline &own = of(at.side), &other = of(1 - at.side);
    const Vec2 &a = other.material(at.edge), &b = other.material(at.edge + 1);
    out_.push_back({{own.id(), at.corner, other.id(), at.edge, is_corner},
                    own.material(at.corner),
                    a + at.stand.share * (b - a),
                    other.normal(at.edge),
                    at.stand.gap,
                    0});
  }

  std::array<const Outline*, 2> outlines_;
  double reach_;
  std::vector<Meeting>& out_;
  std::set<std::tuple<int, std::uint32_t, std::uint32_t>> near_;  ///< asked already: side, corner, edge
};

}  // namespace

std::vector<Meeting> EntranceSearch::find(const Poses& at) const {
  std::vector<Meeting> out;
  std::vector<Outline> outlines;
  for (std::uint32_t b = 0; b < scene_.num_bodies(); ++b) outlines.emplace_back(scene_.bodies[b], b, at[b]);
  for (const auto& [i, j] : search_.candidates(at, at, 2 * reach_ + scene_.meeting.reach))
    Pairing(outlines[i], outlines[j], reach_, out).find();
  return out;
}

}  // namespace dda
