#include "studies/dda/commands/commands.hpp"
#include "studies/dda/commands/python_command.hpp"

namespace dda {

int command_verify(const CommandLine& line) {
  std::vector<std::string> arguments(line.runs.begin(), line.runs.end());
  if (!line.page.empty()) arguments.insert(arguments.begin(), "--out=" + line.page.string());
  become_python({"verify", "verify", "python3-h5py python3-numpy python3-pandas python3-yaml"}, arguments);
}

}  // namespace dda
