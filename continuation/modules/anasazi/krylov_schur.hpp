#pragma once

#include "continuation/stability/krylov_schur.hpp"

namespace dda {

/// What krylov_schur does, in the module of Trilinos.
Eigenmodes anasazi_krylov_schur(const EigenProblem& problem, const Search& search);

}  // namespace dda
