#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <vector>

#include "continuation/bodies/moving_scene.hpp"

namespace dda {

/// Which vertex of a core meets what of another core: an edge, or the corner where an edge begins.
struct MeetingKey {
  std::uint32_t body = 0, vertex = 0, other = 0, edge = 0;
  bool is_corner = false;

  friend auto operator<=>(const MeetingKey&, const MeetingKey&) = default;
};

/// A vertex of one core near an edge or a corner of another, nearer than 2s.
struct Meeting {
  MeetingKey key;
  Vec2 at, foot;         ///< the vertex and what faces it, from the undeformed centroids of their bodies [L]
  Vec2 normal;           ///< unit, from the foot to the vertex
  double distance = 0;   ///< d [L]
  double stiffness = 0;  ///< k [F/L]
};

/// Work of a unit force along `direction` between the vertex and the foot of a meeting: what it is on either body.
inline std::array<Vec6, 2> rows_along(const Meeting& meeting, const Vec2& direction) {
  return {affine_rows(meeting.at).transpose() * direction,
          -affine_rows(meeting.foot).transpose() * direction};
}
inline std::array<std::size_t, 2> bodies_of(const Meeting& meeting) {
  return {meeting.key.body, meeting.key.other};
}

/// ψ and its derivatives at δ = 2s − d.
inline ContactResponse response_of(const MeetingRules& rules, const Meeting& meeting) {
  return rules.law->respond(rules.reach - meeting.distance, meeting.stiffness, rules.reach);
}

/// Finds what meets: a sweep over the boxes of the cores, then every vertex against what of the other outline faces it.
///
///     k = ½ α E h,   E the harmonic mean of the two moduli, h the thickness      [F/L]
class MeetingSearch {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  /// Pairs that are joined never meet.
  MeetingSearch(const MovingScene& scene, std::vector<Pair> joined);

  /// Pairs of bodies that come nearer than `reach` 2s anywhere on the straight ways from one pose to another, in order.
  std::vector<Pair> candidates(const Poses& from, const Poses& to) const {
    return candidates(from, to, scene_.meeting.reach);
  }
  /// The same for all that come nearer than `reach`.
  std::vector<Pair> candidates(const Poses& from, const Poses& to, double reach) const;
  /// Meetings among these pairs, in order.
  std::vector<Meeting> find(const std::vector<Pair>& pairs, const Poses& at) const {
    return find(pairs, at, scene_.meeting.reach);
  }
  /// The same for all that is nearer than `reach`.
  std::vector<Meeting> find(const std::vector<Pair>& pairs, const Poses& at, double reach) const;
  /// The largest share of the ways z + a dz that is free: up to 0.8 of the distance to where cores touch.
  double free_share(const std::vector<Pair>& pairs, const Poses& z, const Poses& dz) const;
  /// The first pair whose cores cross each other.
  std::optional<Pair> crossing(const Poses& at) const;
  /// Whether two cores are nowhere nearer than a distance, but for rounding, nor cross.
  bool are_apart(const Pair& pair, const Poses& at, double distance) const;

 private:
  class Placed;
  void meet(const Pair& pair, const Placed& placed, double reach, std::vector<Meeting>& out) const;

  const MovingScene& scene_;
  std::vector<Pair> joined_;  ///< in order
};

}  // namespace dda
