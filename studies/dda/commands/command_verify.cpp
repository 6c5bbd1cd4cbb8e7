#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "framework/base/errors.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/sweep/processes.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// Debian's own: its modules are among the packages that `bootstrap` installs.
constexpr const char* python = "/usr/bin/python3";

/// Names a module that is missing before anything else is done.
constexpr const char* start = R"(import sys
try:
    from ddapath.verify.__main__ import main
except ModuleNotFoundError as error:
    print(f"dda verify: the Python module '{error.name}' is missing; "
          "install python3-h5py python3-numpy python3-pandas python3-yaml", file=sys.stderr)
    sys.exit(4)
sys.exit(main(sys.argv[1:]))
)";

/// The folder that holds the package: lib/python next to the program's bin.
fs::path package_folder() {
  const fs::path folder = fs::path(program_file()).parent_path().parent_path() / "lib" / "python";
  if (!fs::exists(folder / "ddapath" / "verify" / "__main__.py"))
    throw OutputError(
        fmt::format("'{}' does not hold the Python package ddapath, which belongs beside the program; "
                    "build the target `dda` again, or copy `python/ddapath` there",
                    folder.string()));
  return folder;
}

void look_there_first(const fs::path& folder) {
  const char* before = std::getenv("PYTHONPATH");
  const std::string places = before ? folder.string() + ":" + before : folder.string();
  setenv("PYTHONPATH", places.c_str(), 1);
}

}  // namespace

int command_verify(const CommandLine& line) {
  look_there_first(package_folder());
  std::vector<std::string> words{python, "-B", "-P", "-c", start};
  for (const fs::path& run : line.runs) words.push_back(run.string());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(python, arguments.data());
  throw OutputError(fmt::format("cannot start {}: {}; install python3", python, std::strerror(errno)));
}

}  // namespace dda
