#pragma once

#include "continuation/bodies/bonds.hpp"
#include "continuation/integrator/integrator.hpp"
#include "continuation/motion/energy/curvatures.hpp"

namespace dda {

/// What bodies, springs and bonds bear in first order about the beginning of a step, from which poses go ways z:
///
///     strain    V Rᵀ C (E + R z)             R = ∂E/∂y at the beginning
///     springs   k row (row · (y + z) − length)
///     bonds     W Qᵀ t(q + Q z),             Q = ∂q/∂y there; of their laws the secants
///
/// All in global components, as a vector of six per body and a matrix of 6 × 6 per pair. What first-order rotations have
/// let a body grow is no strain of it. Contacts are not among it.
class FirstOrder {
 public:
  FirstOrder(const MovingScene& scene, const std::vector<Bond>& bonds) : scene_(scene), bonds_(bonds) {}

  void begin(const std::vector<BodyCourse>& at);
  /// ∂Π/∂y after some ways, loads included: of held bodies what it takes to hold them [F, F L].
  Eigen::VectorXd forces(const Poses& ways) const;
  /// Of strain, springs and bonds by their secants.
  void add_stiffness(const Poses& ways, Curvatures& out) const;
  /// Pairs of bodies that springs and bonds couple.
  void add_pairs(const std::vector<int>& rows, std::vector<BlockSum::Pair>& out) const;
  /// Whether forces are linear in the ways.
  bool is_linear() const { return bonds_.empty(); }

 private:
  /// A body's strain and its rows.
  struct Strained {
    Vec3 strain;
    Mat36 rows;
  };
  BondState state_of(std::size_t bond, const Poses& ways) const;

  const MovingScene& scene_;
  const std::vector<Bond>& bonds_;
  Poses start_;
  std::vector<Strained> strained_;
  std::vector<BondState> bonded_;
};

/// ½ V E:C:E without what the body has grown by in all directions.
double strain_energy_of(const AffineBlock& block, const BodyCourse& at);

}  // namespace dda
