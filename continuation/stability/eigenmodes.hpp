#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "models/body/mass.hpp"

namespace dda {

/// Unknowns up to which the problem is solved as a dense one: fewer solutions than a Krylov space takes with
/// its overhead.
inline constexpr std::size_t dense_below = 240;

/// Lowest eigenpairs of K φ = μ M φ, K symmetric, M positive definite.
struct Eigenmodes {
  std::vector<double> values;               ///< μ, ascending
  std::vector<std::vector<double>> shapes;  ///< φ, of size n each, φᵀ M φ = 1
};

/// x = A⁻¹ b, both of size n.
using InverseOperator = std::function<void(std::span<const double> b, std::span<double> x)>;

/// What is asked for.
struct EigenProblem {
  InverseOperator solve;  ///< K⁻¹
  /// (K + s M)⁻¹ for s > 0; empty where K + s M is not positive definite.
  std::function<InverseOperator(double s)> shifted;
  Mass mass;                             ///< M; identities for K φ = μ φ
  int count = 6;                         ///< of eigenpairs
  std::optional<int> num_negative = {};  ///< eigenvalues of K below zero, where they are known

  std::size_t n() const { return block_unknowns * mass.num_nodes(); }
};

/// The `count` algebraically lowest pairs.
///
/// Shift-invert, (K + s M)⁻¹ M φ = ν φ, μ = 1/ν − s: first with s = 0 and the factorisation that is there,
/// which gives the pairs nearest to zero. Negative eigenvalues that are missing among them are far from it,
/// as those of cracks that soften steeply are: s grows until K + s M is positive definite, and the largest ν
/// are theirs. Modes that only weak springs oppose would leave the others few digits of K⁻¹: they are found
/// with a small s. Small problems are solved densely, others by Anasazi's block Krylov-Schur method, whose
/// start does not depend on anything but n. Throws std::runtime_error when it does not converge.
Eigenmodes lowest_eigenmodes(const EigenProblem& problem);

/// The same by a dense factorisation of K⁻¹: n solutions, n² numbers.
Eigenmodes dense_eigenmodes(const EigenProblem& problem);

/// Modal assurance criterion, (φᵀ M ψ)² of two shapes with unit norm: 1 for the same mode.
double modal_assurance(std::span<const double> a, std::span<const double> b, const Mass& mass);

}  // namespace dda
