#pragma once

#include <memory>

#include "framework/family.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// What a treatment knows of one of the two blocks of a side.
struct BlockFace {
  Mat3 stiffness;  ///< C [F/L²]
  double trace;    ///< c = max over σ of ∮|σn|² ds / (A σ:C⁻¹:σ) [F/L³], see trace_constant
  double modulus;  ///< E [F/L²]
};

/// A side between two blocks, as a treatment sees it.
struct SideFaces {
  BlockFace first, second;
  double centroid_distance;  ///< [L]
  Vec2 normal;               ///< outward of first
};

/// Rows of one interface point: q = first·d_first + second·d_second, and the mean traction
/// {σ}n = first_stress·d_first + second_stress·d_second whose energy ½ {σ}n·P⁻¹{σ}n is subtracted.
struct PointRows {
  Mat26 first, second;
  Mat26 first_stress = Mat26::Zero(), second_stress = Mat26::Zero();
};

/// How the two sides of an interface are joined: what the trial traction P q of a point is.
///
///     penalty      q = g                     g the jump of displacement in (n, s) [L]
///     consistent   q = g + P⁻¹ {σ}n          {σ}n = w_i σ_i n + w_j σ_j n
///     P = k diag(1, β²)
///
/// A law never knows which treatment called it. Source: models/README.md.
class Treatment {
 public:
  virtual ~Treatment() = default;
  /// k of the side by the treatment's own rule [F/L³].
  virtual double stiffness(const SideFaces& side) const = 0;
  /// The largest k to which a steep law may raise it [F/L³].
  virtual double largest_stiffness(const SideFaces& side) const = 0;
  /// Rows of a point from the displacement rows T of both blocks at it.
  virtual PointRows rows(const SideFaces& side, const Mat26& first, const Mat26& second,
                         const Vec2& p) const = 0;
  /// Weights (w_i, w_j) of the two stresses in {σ}n; zero when stresses do not enter.
  virtual Vec2 stress_weights(const SideFaces& side) const = 0;
};

/// Jump g = [n s]ᵀ(T_j d_j − T_i d_i): rows of the first and of the second block.
PointRows jump_rows(const Vec2& normal, const Mat26& first, const Mat26& second);

using TreatmentFamily = Family<Treatment>;
using TreatmentChoice = Choice<Treatment>;

/// The registry of treatments.
TreatmentFamily& treatments();

}  // namespace dda
