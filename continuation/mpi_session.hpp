#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

namespace dda {

/// What Trilinos and MUMPS need from the start of this process to its end: Kokkos, and MPI under mpirun.
/// Without mpirun MPI starts when something asks for it, which most runs never do.
class MpiSession {
 public:
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

/// Starts MPI if it has not been; the session ends it.
void start_mpi();

/// The ranks of this run; of a run without mpirun one, which needs no MPI.
Teuchos::RCP<const Teuchos::Comm<int>> all_ranks();

}  // namespace dda
