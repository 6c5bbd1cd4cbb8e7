#include "continuation/modules/mpi_start.hpp"

#include <mpi.h>

#include <cstdlib>

namespace dda {
namespace {

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

struct Session {
  /// Threads of loops may send messages, one at a time.
  Session() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
  }
  ~Session() { MPI_Finalize(); }
};

}  // namespace

bool is_under_mpirun() { return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr; }

void start_mpi() {
  int is_started = 0;
  MPI_Initialized(&is_started);
  if (is_started) return;
  if (!is_under_mpirun()) keep_to_one_rank();
  static const Session session;
}

}  // namespace dda
