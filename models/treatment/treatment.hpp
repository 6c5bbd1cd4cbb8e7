#pragma once

#include <memory>

#include "framework/deck/family.hpp"
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
  double length;             ///< of the side [L]
  Vec2 normal;               ///< outward of first
};

/// How a point of a block moves and strains by one of its nodes: by d of the block, or by the gradient of its strain.
struct MotionRows {
  Mat26 displacement = Mat26::Zero();  ///< [L]
  Mat36 strain = Mat36::Zero();
};

/// Rows of one interface point: q = first·d_first + second·d_second, and the mean traction
/// {σ}n = first_stress·d_first + second_stress·d_second whose energy ½ {σ}n·P⁻¹{σ}n is subtracted.
struct PointRows {
  Mat26 first, second;
  Mat26 first_stress = Mat26::Zero(), second_stress = Mat26::Zero();
};

/// Whether a point carries a multiplier m [L], its traction P m: none; as two unknowns of its own; or
/// iterated from solve to solve.
enum class Multiplier { none, unknown, iterated };

/// How the two sides of an interface are joined: what the trial traction P q of a point is.
///
///     penalty               q = g                g the jump of displacement in (n, s) [L]
///     consistent            q = g + P⁻¹ {σ}n     {σ}n = w_i σ_i n + w_j σ_j n
///     lagrange              q = g + m            m unknown, −½ ∫ m·P m added to the energy
///     augmented_lagrangian  q = g + m            m ← P⁻¹ t(q)/(1 + δ) until it stays
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
  /// Rows of a point from those of a node of each block at it.
  virtual PointRows rows(const SideFaces& side, const MotionRows& first, const MotionRows& second,
                         const Vec2& p) const = 0;
  virtual Multiplier multiplier() const { return Multiplier::none; }
  /// δ of multipliers, t = (1 + δ) P m: what they leave open of a joint that holds, g = δ m. Keeps redundant
  /// ones determined, and those of bodies that only touch (`is_separate`) from being wedged; 0 without.
  virtual double perturbation(bool /*is_separate*/) const { return 0; }
  /// Stiffness p̄ of the joint in the physical tangent [F/L³]: that of the trial spring unless it only carries
  /// a multiplier.
  virtual double physical_stiffness(const SideFaces& side) const { return stiffness(side); }
  /// Weights (w_i, w_j) of the two stresses in {σ}n; zero when stresses do not enter.
  virtual Vec2 stress_weights(const SideFaces& side) const = 0;
};

/// E/(distance of the centroids), E = 2 E_i E_j/(E_i + E_j): the unit in which springs across a joint are
/// given [F/L³].
double spring_unit(const SideFaces& side);

/// Jump g = [n s]ᵀ(T_j d_j − T_i d_i): rows of the first and of the second block.
PointRows jump_rows(const Vec2& normal, const Mat26& first, const Mat26& second);

using TreatmentFamily = Family<Treatment>;
using TreatmentChoice = Choice<Treatment>;

/// The registry of treatments.
TreatmentFamily& treatments();

}  // namespace dda
