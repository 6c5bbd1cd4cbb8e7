#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/crack_direction/direction.hpp"

namespace dda {
namespace {

struct NonlocalStressParameters {
  double radius = 3, length = 1.5;
  double inertia = 0.5;
  double least_size = 1.0 / 60;
  double largest_turn = 60;
};

constexpr double degree = std::numbers::pi / 180;

Mat2 tensor(const Vec3& stress) {
  Mat2 out;
  out << stress[0], stress[2], stress[2], stress[1];
  return out;
}

/// ⟨σ⟩₊, what the principal values above zero make of it.
Mat2 tensile_part(const Mat2& stress) {
  const Eigen::SelfAdjointEigenSolver<Mat2> principal(stress);
  const Mat2& axes = principal.eigenvectors();
  return axes * principal.eigenvalues().cwiseMax(0.0).asDiagonal() * axes.transpose();
}

/// Normal to the major axis of a mean of the tensile stress ahead, and of what has opened the crack so far:
///
///     S = Σ w ⟨σ⟩₊ / Σ w + ι f n₀ n₀ᵀ        w = r exp(−r²/2l²) over the half disc r < R ahead of the tip
///
/// Ahead of a cohesive zone tension is nearly the same in all directions, so that there is no principal axis to
/// speak of: without the inertia ι cracks in ductile beams curl, and with it they lag by about ι h on a curve. Nothing has
/// opened a crack that begins: its first segment has no inertia, so that the direction in which it is begun decides next to
/// nothing.
/// R, l and that lag are lengths of the material where blocks are small: they count in h* = max(h, l_ch/60), and the
/// inertia is ι h*/h. In block sizes alone a finer pattern would see less and less of the body beyond the cohesive
/// zone's end, and its cracks curl again. Without any tension ahead the crack goes straight on.
class NonlocalStress final : public CrackDirection {
 public:
  explicit NonlocalStress(const NonlocalStressParameters& p) : p_(p) {}

  Vec2 aim(const CrackTip& tip) const override {
    const Vec2 normal(-tip.direction.y(), tip.direction.x());
    const double inertia = tip.has_grown ? p_.inertia * size(tip) / tip.block_size : 0;
    const Mat2 s = mean_ahead(tip) + inertia * tip.strength * normal * normal.transpose();
    const Vec2 opens = Eigen::SelfAdjointEigenSolver<Mat2>(s).eigenvectors().col(1);
    const Vec2 along(opens.y(), -opens.x());
    const Vec2 forward = along.dot(tip.direction) < 0 ? Vec2(-along) : along;
    const double turn = std::atan2(cross(tip.direction, forward), tip.direction.dot(forward));
    return turned(tip.direction, std::clamp(turn, -p_.largest_turn * degree, p_.largest_turn * degree));
  }

 private:
  /// h*.
  double size(const CrackTip& tip) const {
    return std::max(tip.block_size, p_.least_size * tip.characteristic_length);
  }

  static Vec2 turned(const Vec2& v, double angle) {
    return std::cos(angle) * v + std::sin(angle) * Vec2(-v.y(), v.x());
  }

  Mat2 mean_ahead(const CrackTip& tip) const {
    constexpr int rings = 12, rays = 25;
    const double radius = p_.radius * size(tip), length = p_.length * size(tip);
    Mat2 sum = Mat2::Zero();
    double weights = 0;
    for (int i = 0; i < rings; ++i) {
      const double r = (i + 0.5) / rings * radius, weight = r * std::exp(-r * r / (2 * length * length));
      for (int j = 0; j < rays; ++j) {
        const double angle = ((j + 0.5) / rays - 0.5) * std::numbers::pi;
        const auto stress = tip.stress(tip.at + r * turned(tip.direction, angle));
        if (!stress) continue;
        sum += weight * tensile_part(tensor(*stress));
        weights += weight;
      }
    }
    return weights > 0 ? Mat2(sum / weights) : sum;
  }

  NonlocalStressParameters p_;
};

Schema<NonlocalStressParameters> schema() {
  using P = NonlocalStressParameters;
  return Schema<P>("Normal to the largest principal value of the mean tensile stress ahead, with inertia.")
      .number("radius", &P::radius,
              {.fallback = 3.0, .bounds = above(0), .text = "Of the half disc ahead, in block sizes."})
      .number("length", &P::length,
              {.fallback = 1.5, .bounds = above(0), .text = "l of the weight exp(−r²/2l²), in block sizes."})
      .number(
          "inertia", &P::inertia,
          {.fallback = 0.5,
           .bounds = at_least(0),
           .text = "Share of the tensile strength that keeps the crack straight; below 0.5 cracks in ductile "
                   "structures may curl, more lags behind on curves."})
      .number(
          "least_size", &P::least_size,
          {.fallback = 1.0 / 60,
           .bounds = at_least(0),
           .text = "Blocks count as no smaller than this share of l_ch = E Gf/ft²; the inertia grows by as "
                   "much, so that what the crack sees and by how much it lags stay the material's."})
      .number("largest_turn", &P::largest_turn,
              {.fallback = 60.0, .bounds = between(0, 90), .text = "Of one segment, in degrees."});
}

std::unique_ptr<CrackDirection> make(const NonlocalStressParameters& p) {
  return std::make_unique<NonlocalStress>(p);
}

}  // namespace

DDA_REGISTER(crack_directions(), "nonlocal_stress", schema(), make);

}  // namespace dda
