#include "models/crack/initiation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace dda {
namespace {

/// A side that a crack may begin on.
struct Edge {
  BlockId block;
  Vec2 start, end;  ///< counter-clockwise along the block
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

std::vector<Edge> edges_of(const Body& body, const std::map<int, double>& strength) {
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

class Recovery {
 public:
  Recovery(const Body& body, const BlockStress& stress, double radius)
      : body_(body), stress_(stress), radius_(radius) {}

  Recovered at(const Vec2& x, int region) const {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 6> right = Eigen::Matrix<double, 3, 6>::Zero();
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
      const Block& block = body_.assembly.blocks[b];
      const Vec2 away = (block.moments.centroid - x) / radius_;
      if (block.region != region || away.squaredNorm() > 1) continue;
      const Eigen::Vector3d basis(1, away.x(), away.y());
      normal += basis * basis.transpose();
      Eigen::Matrix<double, 1, 6> both;
      both << stress_.dead[b].transpose(), stress_.live[b].transpose();
      right += basis * both;
    }
    const Eigen::Matrix<double, 1, 6> s = value(normal, right);
    return {tensor(s[0], s[1], s[2]), tensor(s[3], s[4], s[5])};
  }

 private:
  /// Of the fit; the mean where the blocks' middles do not span the plane.
  static Eigen::Matrix<double, 1, 6> value(const Eigen::Matrix3d& normal,
                                           const Eigen::Matrix<double, 3, 6>& right) {
    if (normal(0, 0) == 0) return Eigen::Matrix<double, 1, 6>::Zero();
    constexpr double flat = 1e-6;
    if (normal.determinant() <= flat * std::pow(normal(0, 0), 3)) return right.row(0) / normal(0, 0);
    return normal.ldlt().solve(right).row(0);
  }

  const Body& body_;
  const BlockStress& stress_;
  double radius_;
};

bool is_near_a_cut(const CrackGeometry& cracks, const CrackStarts::Wish& wish, const Vec2& x) {
  return std::ranges::any_of(cracks.cuts(), [&](const Cut& cut) {
    return cut.crack != wish.except && distance(x, cut.start, cut.end) < wish.apart;
  });
}

/// Across the largest tension at the critical load, into the body.
Vec2 way_from(const Recovered& at, double load_factor, const Vec2& inward) {
  const Eigen::SelfAdjointEigenSolver<Mat2> principal(at.dead + load_factor * at.live);
  const Vec2 opens = principal.eigenvectors().col(1), along(-opens.y(), opens.x());
  return along.dot(inward) < 0 ? Vec2(-along) : along;
}

}  // namespace

std::vector<CrackStart> CrackStarts::places(const BlockStress& stress, const Wish& wish) const {
  constexpr double reach = 3;  // block sizes
  const Recovery recovery(body_, stress, reach * cracks_.block_size());
  std::vector<CrackStart> out;
  for (const Edge& edge : edges_of(body_, wish.strength))
    for (const double share : {1.0 / 6, 0.5, 5.0 / 6}) {
      const Vec2 x = edge.start + share * (edge.end - edge.start);
      if (is_near_a_cut(cracks_, wish, x)) continue;
      const int region = body_.block(edge.block).region;
      const Recovered at = recovery.at(x, region);
      const double load_factor = critical(at, wish.strength.at(region));
      if (!std::isfinite(load_factor)) continue;
      const Vec2 along = edge.end - edge.start;
      out.push_back({x, way_from(at, load_factor, {-along.y(), along.x()}), load_factor});
    }
  std::ranges::stable_sort(out, {}, &CrackStart::load_factor);
  return out;
}

}  // namespace dda
