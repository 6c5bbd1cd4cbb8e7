#include <dmumps_c.h>
#include <mpi.h>

#include "continuation/modules/mpi_start.hpp"

/// What continuation/linear/direct/mumps_matrix.cpp loads: MUMPS on this process alone, with MPI, which it asks for
/// its ranks.
extern "C" void dda_mumps(DMUMPS_STRUC_C* instance) {
  dda::start_mpi();
  instance->comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(MPI_COMM_SELF));
  dmumps_c(instance);
}
