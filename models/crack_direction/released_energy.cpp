#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "models/crack_direction/direction.hpp"

namespace dda {
namespace {

struct ReleasedEnergyParameters {
  double length = 3;
  double least_size = 1.0 / 60;
  double step = 12;
  double largest_turn = 48;
};

constexpr double degree = std::numbers::pi / 180;

/// The way that releases most energy: straight ways of one length L that bear no tension are tried at angles θ a step
/// apart, from straight on to whichever side releases more, until one between two others releases most; the way is the
/// top of the parabola through these three, and straight on where none is found,
///
///     ΔΠ(θ) = ½ rᵀ K⁻¹ r          r the forces that tension along the way has held, with the shear beside it, K with
///                                 cracks free where they bear nothing and held where they do
///
/// the finite form of the largest energy release rate (Hussain, Pu & Underwood 1974; cohesive: Dumstorff & Meschke
/// 2007). Where the way is pressed it stays closed and releases nothing. L is `length` h*, h* = max(h, l_ch/60):
/// shorter than the cohesive zone it would see the tip alone, where tension is nearly the same in all directions. Each
/// angle costs a factorisation.
class ReleasedEnergy final : public CrackDirection {
 public:
  explicit ReleasedEnergy(const ReleasedEnergyParameters& p) : p_(p) {}

  Vec2 aim(const CrackTip& tip) const override {
    const double length = p_.length * std::max(tip.block_size, p_.least_size * tip.characteristic_length);
    std::map<int, double> tried;
    const auto at = [&](int k) {
      const auto known = tried.find(k);
      if (known != tried.end()) return known->second;
      return tried[k] = tip.released(turned(tip.direction, k * p_.step * degree), length).value_or(0);
    };
    int best = 0;
    const int most = static_cast<int>(p_.largest_turn / p_.step);
    for (int next : {1, -1})
      while (std::abs(best + next) <= most && at(best + next) > at(best)) best += next;
    if (!(at(best) > 0) || std::abs(best) == most) return tip.direction;
    const double turn = (best + top(at(best - 1), at(best), at(best + 1))) * p_.step;
    return turned(tip.direction, std::clamp(turn, -p_.largest_turn, p_.largest_turn) * degree);
  }

 private:
  static Vec2 turned(const Vec2& v, double angle) {
    return std::cos(angle) * v + std::sin(angle) * Vec2(-v.y(), v.x());
  }
  /// Of the parabola through (−1, a), (0, b), (1, c), b the largest.
  static double top(double a, double b, double c) {
    const double bend = a - 2 * b + c;
    return bend < 0 ? (a - c) / (2 * bend) : 0;
  }

  ReleasedEnergyParameters p_;
};

Schema<ReleasedEnergyParameters> schema() {
  using P = ReleasedEnergyParameters;
  return Schema<P>(
             "The straight way that releases most energy when it bears no traction, of some that are tried; "
             "slower, "
             "a check of the others.")
      .number("length", &P::length,
              {.fallback = 3.0, .bounds = above(0), .text = "Of the ways tried, in block sizes."})
      .number("least_size", &P::least_size,
              {.fallback = 1.0 / 60,
               .bounds = at_least(0),
               .text = "Blocks count as no smaller than this share of l_ch = E Gf/ft²."})
      .number("step", &P::step,
              {.fallback = 12.0, .bounds = between(1, 45), .text = "Between the angles tried, in degrees."})
      .number("largest_turn", &P::largest_turn,
              {.fallback = 48.0, .bounds = between(0, 90), .text = "Of one segment, in degrees."});
}

}  // namespace

DDA_REGISTER(crack_directions(), "released_energy", schema(), make_of<ReleasedEnergy>);

}  // namespace dda
