#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

namespace dda {

/// What Trilinos needs while it is in use: Kokkos, and MPI under mpirun. Sessions may lie inside one another.
class TrilinosSession {
 public:
  TrilinosSession();
  ~TrilinosSession();
  TrilinosSession(const TrilinosSession&) = delete;
  TrilinosSession& operator=(const TrilinosSession&) = delete;

 private:
  bool is_outermost_;
};

/// The ranks of this run; of a run without mpirun one, which needs no MPI.
Teuchos::RCP<const Teuchos::Comm<int>> all_ranks();

}  // namespace dda
