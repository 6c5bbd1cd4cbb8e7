#include "studies/dda/sweep/launch/launcher.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "studies/dda/sweep/case_command.hpp"
#include "studies/dda/sweep/processes/processes.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

std::string name_of(const fs::path& folder) { return folder.filename().string(); }

std::size_t cases_of_task(const Forecast& forecast, std::size_t tasks) {
  return (forecast.num_open + tasks - 1) / tasks;
}

/// Comments that say what is asked for, and why.
std::string heading(const fs::path& folder, const Forecast& forecast, std::size_t tasks) {
  std::string out = fmt::format("# {}: {} of {} cases are to be run, by {} processes that share them\n",
                                folder.string(), forecast.num_open, forecast.num_cases, tasks);
  out += "# memory: " + forecast.memory_text;
  if (const double memory = forecast.memory_to_ask(); memory > 0)
    out += fmt::format("; {:.0f} MiB for each process, since cracks take more", memory);
  out += "\n# time: " + forecast.time_text;
  if (const double time = forecast.time_to_ask(cases_of_task(forecast, tasks)); time > 0)
    out += fmt::format("; {:.0f} min for each process, twice that", std::ceil(time / 60));
  return out + "\n";
}

std::string environment() { return "OMP_NUM_THREADS=" + quoted(threads_of_processes()); }

}  // namespace

std::string slurm_script(const Sweep& sweep, const fs::path& folder, const Forecast& forecast,
                         const Launch& launch) {
  std::string out = "#!/bin/bash\n" + heading(folder, forecast, launch.tasks);
  const auto ask = [&](const std::string& option) { out += "#SBATCH --" + option + "\n"; };
  ask("job-name=" + quoted(name_of(folder)));
  ask(fmt::format("array=1-{}", launch.tasks));
  ask("ntasks=1");
  ask("cpus-per-task=" + threads_of_processes());
  if (const double memory = forecast.memory_to_ask(); memory > 0) ask(fmt::format("mem={:.0f}M", memory));
  if (const double time = forecast.time_to_ask(cases_of_task(forecast, launch.tasks)); time > 0)
    ask(fmt::format("time={:.0f}", std::ceil(time / 60)));
  ask("signal=B:TERM@60");  // restart files are written before the time is up
  ask("requeue");
  out += "cd " + quoted(fs::current_path().string()) + " || exit\n";
  return out + environment() + " exec " + line_of_process(sweep, folder) +
         " --no-wait --attempt \"$SLURM_ARRAY_JOB_ID\"\n";
}

std::string parallel_line(const Sweep& sweep, const fs::path& folder, const Forecast& forecast,
                          const Launch& launch) {
  const std::size_t hosts = std::max<std::size_t>(1, launch.hosts.size());
  const std::size_t each = (launch.tasks + hosts - 1) / hosts;
  const std::string line = environment() + " " + line_of_process(sweep, folder) + " --no-wait --attempt ";
  std::string out = heading(folder, forecast, each * hosts);
  out += fmt::format("yes {}\"$(date +%s)\" | head -n {} | parallel --jobs {}", quoted(line), each * hosts,
                     each);
  if (launch.hosts.empty()) return out + "\n";
  return out + fmt::format(" --sshlogin {} --workdir {}\n",
                           quoted(fmt::format("{}", fmt::join(launch.hosts, ","))),
                           quoted(fs::current_path().string()));
}

std::string mpirun_line(const Sweep& sweep, const fs::path& folder, const Forecast& forecast,
                        const Launch& launch) {
  const std::string without_the_dead = " OMPI_MCA_orte_enable_recovery=1";  // else Open MPI ends all with one
  return heading(folder, forecast, launch.tasks) + environment() + without_the_dead +
         fmt::format(" mpirun -n {} {} --attempt \"$(date +%s)\"\n", launch.tasks,
                     line_of_process(sweep, folder));
}

}  // namespace dda
