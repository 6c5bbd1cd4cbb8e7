#pragma once

#include <span>
#include <vector>

#include "models/body/block_matrix.hpp"
#include "models/body/body.hpp"

namespace dda {

/// A symmetric, positive definite matrix by nodes: 6 × 6 on the diagonal, and what few pairs of nodes share.
struct Mass {
  /// M_ij of two nodes; M_ji is its transpose.
  struct Coupling {
    BlockId i, j;
    Mat6 m;
  };

  std::vector<Mat6> diagonal;
  std::vector<Coupling> couplings = {};

  std::size_t num_nodes() const { return diagonal.size(); }
  /// y = M x, both of size 6 · num_nodes().
  void multiply(std::span<const double> x, std::span<double> y) const;
  /// K += s M; K has a place for every coupling.
  void add_to(BlockMatrix& k, double s) const;
  Eigen::MatrixXd dense() const;

  /// Identities, for K φ = μ φ.
  static Mass identity(std::size_t num_nodes) { return {std::vector<Mat6>(num_nodes, Mat6::Identity())}; }
};

/// M = ∫ ρ NᵀN dV of every block, u = N d: of a block T and its strain gradient's G, of the parts that move by a jump J beside it (motion.hpp), which
/// share M with their block. The three unknowns of a jump's node that are none get next to no mass, so that no mode of
/// theirs is among the lowest. With ρ = 1, or with the densities of the materials, all of them above 0.
Mass unit_mass(const Body& body);
Mass mass_of(const Body& body);

}  // namespace dda
