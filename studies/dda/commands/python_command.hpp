#pragma once

#include <string>
#include <vector>

namespace dda {

/// A command that the Python package beside the program does.
struct PythonCommand {
  std::string name;  ///< as of `dda name`
  std::string
      module;  ///< in the package ddapath; its `__main__` has `main(arguments)`, which gives the exit code
  std::string packages;  ///< Debian's, with the modules that it needs
};

/// Becomes Python, which does the command with these arguments. Throws OutputError where the package or Python is
/// missing.
[[noreturn]] void become_python(const PythonCommand& command, const std::vector<std::string>& arguments);

}  // namespace dda
