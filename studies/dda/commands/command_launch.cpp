#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>

#include "studies/dda/commands/commands.hpp"
#include "studies/dda/sweep/launch/launcher.hpp"
#include "studies/dda/sweep/processes/processes.hpp"
#include "studies/dda/sweep/sweep_entrance.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// sbatch reads the script from its standard input.
[[noreturn]] void submit(const std::string& script) {
  const int file = memfd_create("script", 0);
  if (file < 0 || write(file, script.data(), script.size()) != static_cast<ssize_t>(script.size()) ||
      lseek(file, 0, SEEK_SET) != 0 || dup2(file, STDIN_FILENO) < 0)
    throw OutputError(fmt::format("cannot hand the script to sbatch: {}", std::strerror(errno)));
  execlp("sbatch", "sbatch", static_cast<char*>(nullptr));
  throw OutputError(
      fmt::format("cannot start sbatch: {}; without --submit the script is printed", std::strerror(errno)));
}

std::size_t num_tasks(const CommandLine& line, const Forecast& forecast) {
  const std::size_t most = std::max<std::size_t>(1, forecast.num_open);
  if (line.jobs > 0) return std::min(most, static_cast<std::size_t>(line.jobs));
  if (line.shared.launcher == "slurm") return most;
  const std::size_t hosts = std::max<std::size_t>(1, line.shared.hosts.size());
  return std::min(most, hosts * std::max(1U, std::thread::hardware_concurrency()));
}

void refuse_wrong_options(const SharedSweep& shared) {
  if (shared.submit && shared.launcher != "slurm")
    throw InputError(Position{"--submit"},
                     "goes with --launcher slurm alone; the other lines are for a shell");
  if (ranks_of_processes() > 1 && shared.launcher != "parallel")
    throw InputError(
        Position{"--ranks"},
        "goes with runs that this process starts, and with --launcher parallel: mpirun within mpirun or "
        "within a task of Slurm's array has no processors for its ranks");
  if (!shared.hosts.empty() && shared.launcher != "parallel")
    throw InputError(Position{"--hosts"},
                     "goes with --launcher parallel alone; Slurm and mpirun know their hosts themselves");
}

}  // namespace

int launch_sweep(const Sweep& sweep, const fs::path& folder, const CommandLine& line) {
  refuse_wrong_options(line.shared);
  SweepCases cases(sweep, folder, Claims(claims_folder(folder, sweep), line.shared.lease), {});
  const Forecast forecast = forecast_of(sweep, cases.states());
  const Launch launch{num_tasks(line, forecast), line.shared.hosts};
  if (line.shared.submit) {
    if (forecast.num_open == 0) {
      fmt::print("{}: no case is left to be run\n", folder.string());
      return 0;
    }
    enter_sweep(folder, sweep, {.lease = line.shared.lease});
    submit(slurm_script(sweep, folder, forecast, launch));
  }
  const auto text = line.shared.launcher == "slurm"      ? slurm_script
                    : line.shared.launcher == "parallel" ? parallel_line
                                                         : mpirun_line;
  fmt::print("{}", text(sweep, folder, forecast, launch));
  return 0;
}

}  // namespace dda
