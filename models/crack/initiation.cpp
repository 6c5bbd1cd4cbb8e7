#include "models/crack/initiation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace dda {
namespace {

// In block sizes: how far fits reach, and where before a corner its tension is asked for.
constexpr double fit_reach = 3, before_corner = 0.25;
constexpr double leaves_at_least = 45 * std::numbers::pi / 180, same_way = 30 * std::numbers::pi / 180;

using Strengths = std::map<int, LocalStrength>;  // by region

/// A side that a crack may begin on.
struct Edge {
  BlockId block;
  Vec2 start, end;  ///< counter-clockwise along the block

  Vec2 along() const { return (end - start).normalized(); }
  Vec2 inward() const { return {-along().y(), along().x()}; }
  Vec2 at(double share) const { return start + share * (end - start); }
};

/// A place that a crack may begin at.
struct CrackSite {
  Vec2 x, inward;
  BlockId block;
  std::optional<Edge> edge = {};  ///< none of a re-entrant corner
  double singularity = 0;         ///< e of a corner, stress ∝ r⁻ᵉ
};

/// σ and dσ/dλ at a point.
struct Recovered {
  Mat2 dead, live;
};

Mat2 tensor(double xx, double yy, double xy) {
  Mat2 out;
  out << xx, xy, xy, yy;
  return out;
}

std::vector<Edge> edges_of(const Body& body, const Strengths& strength) {
  const auto may_crack = [&](BlockId block) { return strength.contains(body.block(block).region); };
  std::vector<Edge> out;
  for (const BoundarySide& side : body.assembly.boundary)
    if (may_crack(side.block)) out.push_back({side.block, side.start, side.end});
  for (const Side& side : body.assembly.sides) {
    if (!side.curve && body.block(side.first).region == body.block(side.second).region) continue;
    if (may_crack(side.first)) out.push_back({side.first, side.start, side.end});
    if (may_crack(side.second)) out.push_back({side.second, side.end, side.start});
  }
  return out;
}

/// e of the stress r⁻ᵉ that opens a re-entrant corner of angle ω within the body, whose faces are free of stress:
/// sin((1 − e) ω) + (1 − e) sin ω = 0, from 0 of a straight edge to ½ of a slit.
double singularity_of(double angle) {
  const auto is_below = [&](double e) { return std::sin((1 - e) * angle) + (1 - e) * std::sin(angle) < 0; };
  double low = 0, high = 0.5;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (is_below(middle) ? low : high) = middle;
  }
  return low;
}

/// Of the body between a side of its boundary and the one that goes on from its end, counter-clockwise from that to the side's
/// way back, in (0, 2π]: π along a straight edge, 2π about the tip of a slit.
double angle_between(const BoundarySide& to, const BoundarySide& from) {
  constexpr double closed = 1e-6;
  const Vec2 back = to.start - to.end, on = from.end - from.start;
  const double angle = std::atan2(cross(on, back), on.dot(back));
  return angle > closed ? angle : angle + 2 * std::numbers::pi;
}

/// Where the boundary turns away from the body by more than a hole's outline does, such as the tip of a slit. The two faces of
/// a slit pass each other at corners of blocks: what goes on from one of them is the side that leaves least of the body between.
std::vector<CrackSite> corners_of(const Body& body, const Strengths& strength, double tolerance) {
  constexpr double least = std::numbers::pi * 7 / 6;
  std::vector<CrackSite> out;
  for (const BoundarySide& to : body.assembly.boundary) {
    if (!strength.contains(body.block(to.block).region)) continue;
    const BoundarySide* on = nullptr;
    for (const BoundarySide& from : body.assembly.boundary)
      if ((from.start - to.end).norm() <= tolerance &&
          (!on || angle_between(to, from) < angle_between(to, *on)))
        on = &from;
    if (!on || angle_between(to, *on) < least) continue;
    const Vec2 a = (to.end - to.start).normalized(), b = (on->end - on->start).normalized();
    out.push_back({to.end, (a - b).normalized(), to.block, {}, singularity_of(angle_between(to, *on))});
  }
  return out;
}

/// Re-entrant corners, and of every edge some places that none of these is close to: what bears there is the corner.
std::vector<CrackSite> places_on(const Body& body, const Strengths& strength, double close,
                                 double tolerance) {
  std::vector<CrackSite> out = corners_of(body, strength, tolerance);
  const std::vector<CrackSite> corners = out;
  for (const Edge& edge : edges_of(body, strength))
    for (const double share : {1.0 / 6, 0.5, 5.0 / 6}) {
      const Vec2 x = edge.at(share);
      if (std::ranges::none_of(corners,
                               [&](const CrackSite& corner) { return (corner.x - x).norm() < close; }))
        out.push_back({x, edge.inward(), edge.block, edge});
    }
  return out;
}

/// The smallest λ ≥ 0 for which σ + λ dσ/dλ has the principal value f: where det(σ − f I + λ dσ/dλ) first vanishes.
double critical(const Recovered& at, double f) {
  const Mat2 a = at.dead - f * Mat2::Identity(), &b = at.live;
  if (a(0, 0) >= 0 || a.determinant() <= 0) return 0;
  const double square = b.determinant(), whole = a.determinant(),
               half = (a(0, 0) * b(1, 1) + a(1, 1) * b(0, 0) - 2 * a(0, 1) * b(0, 1)) / 2;
  const double root = half * half - square * whole;
  constexpr double never = std::numeric_limits<double>::infinity();
  if (root < 0) return never;
  // Both roots are whole/(−half ± √root) in a form that cannot cancel; the one closest above zero has the larger
  // denominator.
  const double down = -half + std::sqrt(root);
  return down > 0 ? whole / down : never;
}

/// Whether a straight line leads out of the body through a side of its boundary; those that it begins on are none.
bool leads_through(const BoundarySide& side, const Vec2& from, const Vec2& to, double tolerance) {
  const Vec2 edge = side.end - side.start, way = to - from;
  const auto apart = [](double a, double b) { return (a > 0) != (b > 0); };
  const double beside = cross(edge, from - side.start);
  return std::abs(beside) > tolerance * edge.norm() && apart(beside, cross(edge, to - side.start)) &&
         apart(cross(way, side.start - from), cross(way, side.end - from));
}

class Recovery {
 public:
  Recovery(const Body& body, const BlockStress& stress, double radius, double tolerance)
      : body_(body), stress_(stress), radius_(radius), tolerance_(tolerance) {}

  Recovered at(const CrackSite& place) const { return recovered(fitted(place)); }

  /// Before a corner, where stress has no bound.
  Recovered before(const CrackSite& corner) const { return recovered(at_corner(corner)); }

 private:
  using Stresses = Eigen::Matrix<double, 1, 6>;  ///< dead, and for a unit of λ
  /// A block that a straight line from the place leads to.
  struct Seen {
    Vec2 away;  ///< in radii
    Stresses stresses;
  };

  std::vector<Seen> seen_from(const CrackSite& place) const {
    std::vector<const BoundarySide*> close;
    for (const BoundarySide& side : body_.assembly.boundary)
      if (distance(place.x, side.start, side.end) <= radius_) close.push_back(&side);
    std::vector<Seen> out;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
      const Block& block = body_.assembly.blocks[b];
      const Vec2 away = (block.moments.centroid - place.x) / radius_;
      if (block.region != body_.block(place.block).region || away.norm() > 1) continue;
      if (!sees(place, block.moments.centroid, close)) continue;
      Stresses both;
      both << stress_.dead[b].transpose(), stress_.live[b].transpose();
      out.push_back({away, both});
    }
    return out;
  }

  static Recovered recovered(const Stresses& s) {
    return {tensor(s[0], s[1], s[2]), tensor(s[3], s[4], s[5])};
  }

  /// s of the fit of s b(x) + G (x − x₀), by its function b of the way from the place [radii].
  template <class Function>
  Stresses fitted(const CrackSite& place, Function function) const {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 6> right = Eigen::Matrix<double, 3, 6>::Zero();
    for (const Seen& seen : seen_from(place)) {
      const Eigen::Vector3d basis(function(seen.away.norm()), seen.away.x(), seen.away.y());
      normal += basis * basis.transpose();
      right += basis * seen.stresses;
    }
    return value(normal, right);
  }

  Stresses fitted(const CrackSite& place) const {
    return fitted(place, [](double) { return 1.0; });
  }

  /// σ = s (ρ/r)ᵉ + G (x − x₀) fitted likewise: s.
  Stresses at_corner(const CrackSite& place) const {
    constexpr double least = before_corner / fit_reach;
    return fitted(place,
                  [&](double away) { return std::pow(least / std::max(away, least), place.singularity); });
  }

  /// Whether a straight line leads there within the body: what lies behind a slit is not joined to its face.
  bool sees(const CrackSite& place, const Vec2& x, const std::vector<const BoundarySide*>& close) const {
    if ((x - place.x).dot(place.inward) <= 0) return false;
    return std::ranges::none_of(
        close, [&](const BoundarySide* side) { return leads_through(*side, place.x, x, tolerance_); });
  }

  /// Of the fit; the mean where the blocks' middles do not span the plane.
  static Stresses value(const Eigen::Matrix3d& normal, const Eigen::Matrix<double, 3, 6>& right) {
    if (normal(0, 0) == 0) return Stresses::Zero();
    constexpr double flat = 1e-6;
    if (normal.determinant() <= flat * std::pow(normal(0, 0), 3)) return right.row(0) / normal(0, 0);
    return normal.ldlt().solve(right).row(0);
  }

  const Body& body_;
  const BlockStress& stress_;
  double radius_, tolerance_;
};

/// Whether a cut relieves a place: it is next to it, or close and a straight line leads there within the body, not across a
/// hole or a notch.
bool is_near_a_cut(const CrackGeometry& cracks, const CrackStarts::Wish& wish, const Vec2& x) {
  const auto is_hidden = [&](const Vec2& from) {
    return std::ranges::any_of(cracks.assembly().boundary, [&](const BoundarySide& side) {
      return leads_through(side, x, from, cracks.tolerance());
    });
  };
  const double close = next_to_a_crack * cracks.block_size();
  return std::ranges::any_of(cracks.cuts(), [&](const Cut& cut) {
    const double away = distance(x, cut.start, cut.end);
    return cut.crack != wish.except && away < wish.apart &&
           (away < close || !is_hidden((cut.start + cut.end) / 2));
  });
}

bool is_held(const CrackSite& place, std::span<const BoundaryPoint> held) {
  constexpr double along = 0.99;
  return place.edge && std::ranges::any_of(held, [&](const BoundaryPoint& point) {
           return point.block == place.block && point.normal.dot(-place.edge->inward()) > along;
         });
}

/// The same of the tension along a direction alone.
double critical_along(const Recovered& at, const Vec2& t, double f) {
  const double dead = t.dot(at.dead * t), live = t.dot(at.live * t);
  if (dead >= f) return 0;
  return live > 0 ? (f - dead) / live : std::numeric_limits<double>::infinity();
}

/// The principal axes at a load, turned into the body: across the largest tension, and along it.
std::pair<Vec2, Vec2> ways_from(const Recovered& at, double load_factor, const Vec2& inward) {
  const Eigen::SelfAdjointEigenSolver<Mat2> principal(at.dead + load_factor * at.live);
  const auto turned = [&](const Vec2& way) { return way.dot(inward) < 0 ? Vec2(-way) : way; };
  const Vec2 opens = principal.eigenvectors().col(1);
  return {turned({-opens.y(), opens.x()}), turned(opens)};
}

/// At a corner the load is that of the tension before it, the direction that of the linear field.
CrackStart start_at_corner(const CrackSite& corner, const Recovery& recovery, double f) {
  const double first = critical(recovery.before(corner), f);
  if (!std::isfinite(first)) return {corner.x, corner.inward, first};
  return {corner.x, ways_from(recovery.at(corner), first, corner.inward).first, first};
}

/// What a load, a drive or a support brings onto an edge opens no crack along it: where the largest tension would, the
/// one along the edge counts.
CrackStart start_on_edge(const CrackSite& place, const Recovered& at, double f) {
  const double first = critical(at, f);
  if (std::isfinite(first)) {
    const Vec2 way = ways_from(at, first, place.inward).first;
    if (way.dot(place.inward) >= std::cos(leaves_at_least)) return {place.x, way, first};
  }
  const double later = critical_along(at, place.edge->along(), f);
  if (!std::isfinite(later)) return {place.x, place.inward, later};
  const auto [across, along] = ways_from(at, later, place.inward);
  return {place.x, across.dot(place.inward) >= along.dot(place.inward) ? across : along, later};
}

/// Whether the boundary goes the same way, closer than a block.
bool runs_along_boundary(const Body& body, const CrackStart& start, double block_size) {
  return std::ranges::any_of(body.assembly.boundary, [&](const BoundarySide& side) {
    const Vec2 s = side.start - start.at, e = side.end - start.at;
    const bool is_ahead = std::max(s.dot(start.direction), e.dot(start.direction)) > 0.1 * block_size;
    return is_ahead && distance(start.at, side.start, side.end) < 0.5 * block_size &&
           std::abs((e - s).normalized().dot(start.direction)) > std::cos(same_way);
  });
}

}  // namespace

std::vector<ShallowCorner> CrackStarts::shallow(const std::map<int, LocalStrength>& strength) const {
  constexpr double enough = 4;  // block sizes
  std::vector<ShallowCorner> out;
  for (const CrackSite& corner : corners_of(body_, strength, cracks_.tolerance())) {
    double depth = std::numeric_limits<double>::infinity();
    for (const BoundarySide& side : body_.assembly.boundary) {
      const Vec2 edge = side.end - side.start, to = side.start - corner.x;
      const double across = cross(corner.inward, edge), share = cross(to, corner.inward) / across;
      const double away = cross(to, edge) / across;
      if (share >= 0 && share <= 1 && away > cracks_.tolerance()) depth = std::min(depth, away);
    }
    if (depth < enough * cracks_.block_size()) out.push_back({corner.x, depth / cracks_.block_size()});
  }
  return out;
}

std::vector<CrackStart> CrackStarts::places(const BlockStress& stress, const Wish& wish) const {
  const double h = cracks_.block_size(), radius = fit_reach * h;
  const Recovery recovery(body_, stress, radius, cracks_.tolerance());
  std::vector<CrackStart> out;
  for (const CrackSite& place : places_on(body_, wish.strength, radius, cracks_.tolerance())) {
    if (is_near_a_cut(cracks_, wish, place.x) || is_held(place, wish.held)) continue;
    const LocalStrength& strength = wish.strength.at(body_.block(place.block).region);
    const double f = strength.at(place.x);
    const CrackStart start =
        place.edge ? start_on_edge(place, recovery.at(place), f) : start_at_corner(place, recovery, f);
    if (std::isfinite(start.load_factor) && !runs_along_boundary(body_, start, h)) out.push_back(start);
  }
  std::ranges::stable_sort(out, {}, &CrackStart::load_factor);
  return out;
}

}  // namespace dda
