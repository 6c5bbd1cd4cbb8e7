#include "continuation/modules/trilinos_session.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_DefaultSerialComm.hpp>

#include "continuation/modules/mpi_start.hpp"

namespace dda {

TrilinosSession::TrilinosSession() : is_outermost_(!Kokkos::is_initialized()) {
  if (is_under_mpirun()) start_mpi();
  if (is_outermost_) Kokkos::initialize();
}

TrilinosSession::~TrilinosSession() {
  if (is_outermost_) Kokkos::finalize();
}

Teuchos::RCP<const Teuchos::Comm<int>> all_ranks() {
  if (is_under_mpirun()) return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  return Teuchos::rcp(new Teuchos::SerialComm<int>);
}

}  // namespace dda
