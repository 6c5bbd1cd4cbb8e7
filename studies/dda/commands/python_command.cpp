#include "studies/dda/commands/python_command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>

#include "framework/base/errors.hpp"
#include "framework/base/loaded.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

/// Debian's own: its modules are among the packages that `bootstrap` installs.
constexpr const char* python = "/usr/bin/python3";

/// Names a module that is missing before anything else is done.
constexpr const char* start = R"(import importlib, sys
command, module, packages, *arguments = sys.argv[1:]
try:
    main = importlib.import_module(f"ddapath.{module}.__main__").main
except ModuleNotFoundError as error:
    print(f"dda {command}: the Python module '{error.name}' is missing; install {packages}", file=sys.stderr)
    sys.exit(4)
sys.exit(main(arguments))
)";

/// The folder that holds the package: share/ddapath/python next to the program's bin.
fs::path package_folder(const std::string& module) {
  const fs::path folder = installation() / "share" / "ddapath" / "python";
  if (!fs::exists(folder / "ddapath" / module / "__main__.py"))
    throw OutputError(
        fmt::format("'{}' does not hold the Python package ddapath, which belongs beside the program; "
                    "build the target `dda` again, or copy `python/ddapath` there",
                    folder.string()));
  return folder;
}

/// An empty place among PYTHONPATH's would be the current folder, where a `copy.py` or a `random.so` of the user's may lie.
void look_there_first(const fs::path& folder) {
  std::string places = folder.string();
  const char* before = std::getenv("PYTHONPATH");
  std::istringstream rest(before ? before : "");
  for (std::string place; std::getline(rest, place, ':');)
    if (!place.empty()) places += ":" + place;
  setenv("PYTHONPATH", places.c_str(), 1);
}

}  // namespace

void become_python(const PythonCommand& command, const std::vector<std::string>& arguments) {
  look_there_first(package_folder(command.module));
  std::vector<std::string> words{python, "-B",         "-P",           "-c",
                                 start,  command.name, command.module, command.packages};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(python, pointers.data());
  throw OutputError(fmt::format("cannot start {}: {}; install python3", python, std::strerror(errno)));
}

}  // namespace dda
