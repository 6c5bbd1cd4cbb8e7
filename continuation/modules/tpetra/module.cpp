#include "continuation/modules/anasazi/krylov_schur.hpp"
#include "continuation/modules/tpetra/block_vector.hpp"
#include "continuation/modules/trilinos_session.hpp"
#include "continuation/stability/krylov_schur.hpp"

namespace {

void begin_session() { static const dda::TrilinosSession session; }

}  // namespace

/// A vector of so many unknowns of blocks, for whoever takes it.
extern "C" dda::LocalVector* dda_block_vector(std::size_t size) {
  begin_session();
  return new dda::BlockVector(Teuchos::rcp(new dda::TpetraMap(size, 0, dda::this_rank())));
}

/// What continuation/stability/krylov_schur.cpp loads.
extern "C" void dda_krylov_schur(const dda::EigenProblem& problem, const dda::Search& search,
                                 dda::Eigenmodes& found) {
  begin_session();
  found = dda::anasazi_krylov_schur(problem, search);
}
