#pragma once

#include <memory>

#include "framework/family.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// What an interface point remembers of the last accepted step.
struct History {
  double kappa = 0;      ///< κ, largest equivalent trial opening reached so far [L]
  bool loading = false;  ///< the point sits on its damage surface and the path leaves it by loading
};

/// Traction and tangent of one interface point in its local frame (n, s).
struct Response {
  Vec2 traction = Vec2::Zero();  ///< t [F/L²]
  Mat2 tangent = Mat2::Zero();   ///< ∂t/∂q [F/L³]
};

/// What an interface does with the trial opening q of its two sides, in the local frame (n, s).
///
///     t = ∂ψ/∂q                 traction, size 2                    [F/L²]
///     D = ∂t/∂q                 tangent, 2 × 2, symmetric unless frictional   [F/L³]
///     intact: t = P q,          P = k diag(1, β²)
///
/// q = (q_n, q_s) [L], q_n > 0 opens. A law is softening "rigid until strength" in series with the numerical
/// compliance P⁻¹ of the treatment: its physical opening is w = q − P⁻¹ t. The stiffness k belongs to the
/// point and is passed to every function; the history h is that of the last accepted step and never changes
/// inside a solve. Source: models/README.md.
class InterfaceLaw {
 public:
  virtual ~InterfaceLaw() = default;

  /// β, ratio of the shear to the normal trial stiffness: P = k diag(1, β²).
  virtual double shear_weight() const = 0;
  /// Largest slope −dt/dw of the softening branch [F/L³]; k must exceed it. Zero for laws that do not soften.
  virtual double steepest_slope() const = 0;
  /// Whether the point can ever leave its intact state.
  virtual bool can_crack() const = 0;

  /// κ at which an intact point of stiffness k starts to soften [L]; infinite when it cannot crack.
  virtual double initial_kappa(double k) const = 0;
  /// κ at which the traction has vanished [L]; infinite when it cannot crack.
  virtual double rupture_kappa(double k) const = 0;
  /// Equivalent trial opening q_eq [L], to be compared with κ.
  virtual double equivalent_opening(const Vec2& q) const = 0;
  /// ∂q_eq/∂q, size 2.
  virtual Vec2 opening_gradient(const Vec2& q) const = 0;

  /// Traction and consistent tangent at q. On the damage surface the history's `loading` flag chooses the
  /// side.
  virtual Response respond(const Vec2& q, const History& h, double k) const = 0;
  /// Traction and secant stiffness at q with the damage of h frozen (contact in compression still follows
  /// q_n).
  virtual Response respond_frozen(const Vec2& q, const History& h, double k) const = 0;
  /// Energy dissipated per area by a point whose largest opening is κ, G(κ) [F/L].
  virtual double dissipation(double kappa, double k) const = 0;
  /// dG/dκ [F/L²].
  virtual double dissipation_slope(double kappa, double k) const = 0;
  /// Lost share of the secant stiffness, 0 intact to 1 released.
  virtual double damage(double kappa, double k) const = 0;
};

using LawFamily = Family<InterfaceLaw>;
using LawChoice = Choice<InterfaceLaw>;

/// The registry of interface laws.
LawFamily& interface_laws();

}  // namespace dda
