#pragma once

namespace dda {

/// Whether this process is one of mpirun's.
bool is_under_mpirun();

/// Starts MPI if nothing has; it ends with the process. Most runs never ask for it.
void start_mpi();

}  // namespace dda
