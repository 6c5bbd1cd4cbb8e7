#include "studies/dda/commands/commands.hpp"
#include "studies/dda/commands/python_command.hpp"

namespace dda {

int command_verify(const CommandLine& line) {
  const std::vector<std::string> runs(line.runs.begin(), line.runs.end());
  become_python({"verify", "verify", "python3-h5py python3-numpy python3-pandas python3-yaml"}, runs);
}

}  // namespace dda
