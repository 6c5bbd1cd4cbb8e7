#include <fmt/format.h>

#include "studies/commands.hpp"
#include "studies/summary.hpp"

namespace dda {

int command_resume(const CommandLine& line) {
  std::optional<MpiSession> mpi;
  const RunResult result = resume_run(line.runs.front(), line.overrides, line.run, mpi);
  fmt::print("{}\n", last_line(result));
  return exit_code_of(result.ending);
}

}  // namespace dda
