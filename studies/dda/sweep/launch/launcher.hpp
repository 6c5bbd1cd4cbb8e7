#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "studies/dda/sweep/launch/forecast.hpp"

namespace dda {

/// How a sweep is to be started by many processes.
struct Launch {
  std::size_t tasks = 1;                ///< processes, each of which runs one case at a time
  std::vector<std::string> hosts = {};  ///< of GNU parallel; empty: this machine
};

/// A batch script for Slurm: an array of tasks that share the cases.
std::string slurm_script(const Sweep& sweep, const std::filesystem::path& folder, const Forecast& forecast,
                         const Launch& launch);

/// A line for a shell: GNU parallel, with so many processes on each host.
std::string parallel_line(const Sweep& sweep, const std::filesystem::path& folder, const Forecast& forecast,
                          const Launch& launch);

/// A line for a shell: mpirun starts the processes, which do not use MPI to share the cases.
std::string mpirun_line(const Sweep& sweep, const std::filesystem::path& folder, const Forecast& forecast,
                        const Launch& launch);

}  // namespace dda
