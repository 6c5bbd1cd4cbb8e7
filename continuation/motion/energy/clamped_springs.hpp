#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "continuation/motion/energy/positive_factor.hpp"
#include "models/kinematics/affine.hpp"

namespace dda {

/// A spring between two bodies whose force is bounded: what a contact (0 … ∞) or a slider (−μN … μN) is for small ways.
///
///     φ(x) = k (x₀ + x) within [low, high],      x = Σ alongᵀ dz      [L]
struct ClampedSpring {
  std::array<int, 2> rows = {-1, -1};  ///< of the bodies in what moves; −1 of one that does not
  std::array<Vec6, 2> along = {};      ///< a unit force on either body
  double stiffness = 0;                ///< k [F/L]
  double at = 0;                       ///< x₀ [L]
  double low = 0, high = 0;            ///< [F]

  enum class State { low, within, high };
  State state(double x) const {
    const double force = stiffness * (at + x);
    return force <= low ? State::low : force >= high ? State::high : State::within;
  }
  double force(double x) const { return std::clamp(stiffness * (at + x), low, high); }
};

/// The minimum of a quadratic with clamped springs in it,
///
///     ½ dzᵀ A dz − bᵀ dz + Σ (Φ(x) − Φ(0) − φ(0) x − ½ φ'(0) x²)      x = alongᵀ dz
///
/// with A and b those at dz = 0, springs included. Springs that leave the state they have there change the solution by
/// their unit forces alone, so that A is factorised once: Newton's method on these few, with an exact line search, ends
/// after finitely many steps since the function is convex and has finitely many quadratic pieces.
class ClampedMinimum {
 public:
  /// The factor is that of A; so many springs may change.
  ClampedMinimum(const PositiveFactor& factor, const std::vector<ClampedSpring>& springs, Eigen::Index most);

  /// dz, along which the function falls from dz = 0. Where it takes too many springs, not quite the minimum.
  Eigen::VectorXd solve(const Eigen::VectorXd& b);

 private:
  using State = ClampedSpring::State;
  using Vector = Eigen::VectorXd;

  double stretch_of(std::size_t spring, Eigen::Ref<const Vector> dz) const;
  Vector stretches_of(const Vector& dz) const;
  bool include_changed(const Vector& x);
  void add_halves();
  Vector way_by(const Vector& forces) const;
  Vector forces_for(const Vector& x) const;
  double share_of_way(const Vector& x, const Vector& way, const std::array<double, 2>& quadratic) const;
  Vector of_changed(const Vector& all) const;
  bool has_states_of(const Vector& x, const Vector& other) const;

  const PositiveFactor& factor_;
  const std::vector<ClampedSpring>& springs_;
  Eigen::Index most_;
  std::vector<State> first_;          ///< states at dz = 0
  std::vector<std::size_t> changed_;  ///< springs that have left them at some time
  std::vector<bool> is_changed_;
  Vector unchanged_;                          ///< stretches where no spring leaves its state
  std::vector<PositiveFactor::Half> halves_;  ///< of A⁻¹ and their unit forces
  Eigen::MatrixXd stretches_;                 ///< of one of them where another one pulls
};

}  // namespace dda
