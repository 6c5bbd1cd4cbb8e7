#pragma once

#include <memory>

#include "framework/deck/family.hpp"

namespace dda {

/// Value of a contact's potential and its derivatives with respect to the overlap.
struct ContactResponse {
  double energy = 0;     ///< ψ [F L]
  double force = 0;      ///< ψ' [F], N ≥ 0
  double stiffness = 0;  ///< ψ'' [F/L]
};

/// What two bodies that meet at a point store. Their outlines are shrunk by s, and the distance d of these cores tells how
/// far the bodies themselves overlap, δ = 2s − d: a contact is where 0 < δ.
///
///     ψ(δ),     ψ'(0) = 0,     convex
///
/// The stiffness k belongs to the point [F/L], the reach 2s to the scene [L].
class ContactLaw {
 public:
  virtual ~ContactLaw() = default;
  virtual ContactResponse respond(double overlap, double k, double reach) const = 0;
};

using ContactLawFamily = Family<ContactLaw>;
using ContactLawChoice = Choice<ContactLaw>;

/// The registry of contact laws.
ContactLawFamily& contact_laws();

}  // namespace dda
