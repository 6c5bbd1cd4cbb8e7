#pragma once

namespace dda {

/// The processes that a launcher of MPI has started for one run: mpirun, or srun with its plug-in for PMIx.
struct Launched {
  int size = 1;       ///< number of them
  int rank = 0;       ///< this one, from 0
  int size_here = 1;  ///< number of them on this machine
};

/// What the environment tells of them; one process where it tells nothing. MPI is not asked.
Launched launched();

}  // namespace dda
