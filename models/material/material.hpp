#pragma once

#include <memory>

#include "framework/deck/family.hpp"
#include "models/kinematics/first_order.hpp"

namespace dda {

/// Which out-of-plane condition the two-dimensional model stands for.
enum class Plane { stress, strain };

/// What the inside of a block stores: ψ(ε) = ½ εᵀ C ε [F/L²], σ = C ε.
class Material {
 public:
  virtual ~Material() = default;
  /// C, 3 × 3, symmetric positive definite, for (εx, εy, γxy) → (σx, σy, τxy) [F/L²].
  virtual Mat3 stiffness() const = 0;
  /// A modulus [F/L²] by which springs tied to the material are scaled (Young's modulus).
  virtual double modulus() const = 0;
  /// Strain in both directions of the plane that a unit of free strain out of it makes where it is held: ν in plane
  /// strain, 0 where nothing holds it.
  virtual double held_contraction() const { return 0; }
  virtual Plane plane() const = 0;
  /// What comes about out of the plane by (εx, εy, γxy): σz in plane strain [F/L²], εz in plane stress.
  virtual Vec3 out_of_plane() const = 0;
  /// The same by a free strain out of the plane: −E where it is held, else 1.
  virtual double out_of_plane_by_free_strain() const = 0;
  /// ρ [F T²/L⁴], of what moves; 0 where none is given.
  virtual double density() const = 0;
};

using MaterialFamily = Family<Material, Plane>;
using MaterialChoice = Choice<Material, Plane>;

/// The registry of materials.
MaterialFamily& materials();

}  // namespace dda
