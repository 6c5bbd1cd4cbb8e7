#pragma once

#include <string>

#include "verification/support.hpp"

namespace dda::verification {

/// The cantilever E2 with the exact field of Timoshenko and Goodier: clamp at x = 0, tip shear P at x = L.
///
///     u = −P y/(6 E I) [(6 L − 3 x) x + (2 + ν)(y² − H²/4)]
///     v =  P/(6 E I) [3 ν y² (L − x) + (4 + 5 ν) H² x/4 + (3 L − x) x²]
///     σx = −P (L − x) y/I,   σy = 0,   τxy = P/(2 I) (H²/4 − y²),   I = t H³/12
///
/// y is measured from the axis; plane stress. Source: Timoshenko & Goodier, Theory of Elasticity, §21.
struct Cantilever {
  double length = 400, height = 100, thickness = 100;  ///< [mm]
  double young = 27500, poisson = 0.2, shear = 1000;   ///< [MPa], [1], [N]

  double inertia() const { return thickness * height * height * height / 12; }
  Vec2 displacement(const Vec2& x) const;
  Vec3 stress(const Vec2& x) const;
  double tip_deflection() const { return displacement({length, 0}).y(); }

  /// Deck of the cantilever cut into blocks; treatment, points and subdivision in YAML.
  std::string deck(const std::string& subdivision, const std::string& joint) const;
  bool is_plane_strain = false;  ///< then by the moduli E/(1 − ν²) and ν/(1 − ν)
  /// By springs at the Gauss points of its end, pulled to the exact displacements; else its end has exact tractions, and
  /// two points take off its rigid motions.
  bool is_clamped = true;
  std::string kinematics = "first_order";
};

/// The result of one assembly.
struct CantileverResult {
  std::size_t blocks = 0;
  double error = 0;  ///< ‖u_h − u‖/‖u‖ over the blocks, L2
  double tip = 0;    ///< v(L, 0) [mm]
};

/// Solves it: exact tractions on both ends, the clamp's springs pulled to the exact displacement.
CantileverResult solve_cantilever(const Cantilever& beam, const std::string& subdivision,
                                  const std::string& joint);

}  // namespace dda::verification
