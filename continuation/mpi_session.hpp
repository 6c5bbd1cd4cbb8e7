#pragma once

namespace dda {

/// Starts MPI for this process and ends it at the close of the program; Trilinos and MUMPS need it.
///
/// A run without mpirun is told to skip networks and the run-time daemon, which makes the start 15 times
/// faster.
class MpiSession {
 public:
  MpiSession();
  ~MpiSession();
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;
};

}  // namespace dda
