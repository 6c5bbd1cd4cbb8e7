#pragma once

#include <array>
#include <vector>

#include "continuation/bodies/moving_scene.hpp"
#include "models/interface/law.hpp"

namespace dda {

/// An interface point between bodies that still holds, under any rotation.
///
///     q = [n s]ᵀ (x_second − x_first) + P⁻¹ τ + m,      τ = A_first E_first + A_second E_second + τ₀
///     Π = W ψ(q; h) − ½ W τ·P⁻¹ τ
///
/// (n, s) turns with the mean rotation of the two sides, that of the step's start; τ is there in consistent joints, E
/// being Green's strains and τ₀ of what is there without strain, so that for small displacements q and Π are those of the path.
struct Bond {
  std::size_t first = 0, second = 0;                        ///< bodies
  Vec2 at_first, at_second;                                 ///< places, from the undeformed centroids [L]
  Vec2 normal;                                              ///< undeformed, outward of `first`
  Eigen::Matrix<double, 2, 3> stress_first, stress_second;  ///< A [F/L²]
  double weight = 0;                                        ///< W [L²]
  double stiffness = 0;                                     ///< k [F/L³]
  const InterfaceLaw* law = nullptr;
  History history = {};
  int interface = -1;                  ///< by its number in the deck; −1 for none with a name
  Vec2 multiplier = Vec2::Zero();      ///< m, which stays [L]
  Vec2 initial_stress = Vec2::Zero();  ///< τ₀ [F/L²]
  bool is_end = false;                 ///< it joins nothing: it bears pressure, as at an end of a side

  Vec2 trial_stiffness() const {
    const double beta = law->shear_weight();
    return {stiffness, stiffness * beta * beta};
  }
  /// Whether it can tear, and whether nothing is left of it.
  bool can_tear() const { return !is_end && law->can_crack(); }
  bool is_spent() const { return can_tear() && law->is_spent(history, stiffness); }
  bool holds() const { return !is_end && !is_spent(); }
};

/// A bond at some poses, in the frame of the step's start.
struct BondState {
  Vec2 opening = Vec2::Zero();                     ///< q [L]
  Vec2 stress = Vec2::Zero();                      ///< τ [F/L²]
  std::array<Mat26, 2> opening_rows, stress_rows;  ///< ∂q/∂y and ∂τ/∂y, first and second body
};
BondState state_of(const Bond& bond, const Mat2& frame, const Poses& at);
/// By how much its bodies have turned against each other.
double turn_of(const Bond& bond, const Poses& at);
/// Takes from it what it still holds at an opening, but for pressure and friction; what that would have spent is not.
void spend(Bond& bond, const Vec2& opening);
/// Rows n and s of the frame that has turned with both sides.
Mat2 frame_of(const Bond& bond, const Poses& at);

/// Forces on both bodies of a traction t on q and of what P⁻¹ τ takes off: W (∂q/∂yᵀ t − ∂τ/∂yᵀ P⁻¹ τ) [F, F L].
std::array<Vec6, 2> forces_of(const Bond& bond, const BondState& at, const Vec2& traction,
                              const Vec2& stress);
/// Of these the derivative with respect to the pose of a body, by sides, where that of the traction is d.
Mat6 stiffness_of(const Bond& bond, const BondState& state, const Mat2& d,
                  const std::array<std::size_t, 2>& sides);
/// The response at q with all damage as it is, friction bounded by a given closing: the gradient of a potential, as no law
/// is whose friction follows its pressure.
Response frozen_response(const Bond& bond, const Vec2& opening, double closing);
/// The secant of its law at q, with the damage that q leaves, friction not following the pressure: never negative [F/L³].
Mat2 secant_of(const Bond& bond, const Vec2& opening);

/// What it stores, Π, and what accepting q would spend [F L].
double stored_energy(const Bond& bond, const BondState& state);
double spending(const Bond& bond, const BondState& state);

}  // namespace dda
