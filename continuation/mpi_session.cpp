#include "continuation/mpi_session.hpp"

#include <mpi.h>

#include <Tpetra_Core.hpp>
#include <cstdlib>

namespace dda {

MpiSession::MpiSession() {
  if (!std::getenv("OMPI_COMM_WORLD_SIZE")) {
    constexpr int keep = 0;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", keep);
    setenv("OMPI_MCA_btl", "self", keep);
    setenv("OMPI_MCA_pml", "ob1", keep);
    setenv("OMPI_MCA_osc", "^ucx", keep);
    // Processes started side by side remove each other's folder for temporary files; a single rank needs none.
    setenv("OMPI_MCA_orte_create_session_dirs", "0", keep);
  }
  MPI_Init(nullptr, nullptr);
  char program[] = "dda";
  char* arguments[] = {program, nullptr};
  char** argv = arguments;
  int argc = 1;
  Tpetra::initialize(&argc, &argv, MPI_COMM_WORLD);
}

MpiSession::~MpiSession() {
  Tpetra::finalize();
  MPI_Finalize();
}

}  // namespace dda
