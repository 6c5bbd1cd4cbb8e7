#include "framework/base/launched.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace dda {
namespace {

std::optional<int> count_in(const char* name) {
  const char* const text = std::getenv(name);
  if (!text) return {};
  char* end = nullptr;
  const long value = std::strtol(text, &end, 10);
  return end == text ? std::nullopt : std::optional(static_cast<int>(value));
}

/// The variables of one launcher.
struct LauncherNames {
  const char *size, *rank, *size_here;
};

constexpr LauncherNames known[] = {
    {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_LOCAL_SIZE"},  // mpirun of Open MPI
    {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID", "SLURM_STEP_TASKS_PER_NODE"},           // srun: 2, 2(x3), 2,1
    {"PMI_SIZE", "PMI_RANK", "MPI_LOCALNRANKS"},                                     // mpiexec of MPICH
};

}  // namespace

Launched launched() {
  for (const LauncherNames& names : known) {
    const auto size = count_in(names.size), rank = count_in(names.rank);
    if (!size || !rank || *size < 1 || *rank < 0 || *rank >= *size) continue;
    return {*size, *rank, std::clamp(count_in(names.size_here).value_or(*size), 1, *size)};
  }
  return {};
}

}  // namespace dda
