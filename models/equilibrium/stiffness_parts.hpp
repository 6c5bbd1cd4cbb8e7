#pragma once

#include <Eigen/Core>
#include <span>

#include "models/equilibrium/equilibrium.hpp"

namespace dda {

/// The tangent stiffness of an assembly by what contributes to it, each of size n × n, dense.
///
///     K = K⁰ + Kᶜ + Kˢ + Kʷ
///
/// Source: Pearce et al. (2000), eqs 23 and 24.
struct StiffnessParts {
  Eigen::MatrixXd strain;   ///< K⁰, deformation of the blocks
  Eigen::MatrixXd contact;  ///< Kᶜ, joints, with what consistent ones subtract
  Eigen::MatrixXd support;  ///< Kˢ, springs that hold or drive the structure
  Eigen::MatrixXd weak;     ///< Kʷ, springs at the centroids

  Eigen::MatrixXd sum() const { return strain + contact + support + weak; }
};

/// With these tangents D of all points, 2 × 2 each; of blocks, strain gradients and jumps, n = 6 · nodes; multipliers are left
/// out.
StiffnessParts stiffness_parts(const Equilibrium& equilibrium, std::span<const Mat2> tangents);

/// Their sum as a sparse matrix.
BlockMatrix block_stiffness(const Equilibrium& equilibrium, std::span<const Mat2> tangents);

}  // namespace dda
