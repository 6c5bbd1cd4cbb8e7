#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>

namespace dda {

/// What Trilinos needs while it is in use: Kokkos. Sessions may lie inside one another.
class TrilinosSession {
 public:
  TrilinosSession();
  ~TrilinosSession();
  TrilinosSession(const TrilinosSession&) = delete;
  TrilinosSession& operator=(const TrilinosSession&) = delete;

 private:
  bool is_outermost_;
};

/// This process alone, without MPI: what Trilinos does in a run of several ranks is the first one's.
Teuchos::RCP<const Teuchos::Comm<int>> this_rank();

}  // namespace dda
