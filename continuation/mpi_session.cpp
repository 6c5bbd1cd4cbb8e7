#include "continuation/mpi_session.hpp"

#include <mpi.h>

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <cstdlib>

namespace dda {
namespace {

bool is_under_mpirun() { return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr; }

/// No networks, no daemon, no folder for temporary files, which processes started side by side remove from
/// under each other: the start takes 20 ms instead of 300.
void keep_to_one_rank() {
  constexpr int keep = 0;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
  setenv("OMPI_MCA_btl", "self", keep);
  setenv("OMPI_MCA_pml", "ob1", keep);
  setenv("OMPI_MCA_osc", "^ucx", keep);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", keep);
}

bool is_started() {
  int flag = 0;
  MPI_Initialized(&flag);
  return flag != 0;
}

}  // namespace

MpiSession::MpiSession() {
  if (is_under_mpirun()) start_mpi();
  Kokkos::initialize();
}

MpiSession::~MpiSession() {
  Kokkos::finalize();
  if (is_started()) MPI_Finalize();
}

void start_mpi() {
  if (is_started()) return;
  if (!is_under_mpirun()) keep_to_one_rank();
  MPI_Init(nullptr, nullptr);
}

Teuchos::RCP<const Teuchos::Comm<int>> all_ranks() {
  if (is_under_mpirun()) return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
  return Teuchos::rcp(new Teuchos::SerialComm<int>);
}

}  // namespace dda
