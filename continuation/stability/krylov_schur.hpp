#pragma once

#include "continuation/stability/eigenmodes.hpp"

namespace dda {

/// What a Krylov-Schur iteration looks for.
struct Search {
  const InverseOperator& solve;  ///< (K + s M)⁻¹
  double shift;                  ///< s
  int count;                     ///< of pairs
};

/// The pairs of K φ = μ M φ nearest to −s, in no order, by Anasazi's block Krylov-Schur method on (K + s M)⁻¹
/// M, which is symmetric in the inner product of M whether K is definite or not.
///
/// Blocks of three vectors, because a block that hangs on weak springs alone has three equal eigenvalues.
/// Throws std::runtime_error when it does not converge. One rank.
Eigenmodes krylov_schur(const EigenProblem& problem, const Search& search);

}  // namespace dda
