#include "framework/messages/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <string>

#include "dda_version.hpp"

namespace dda {
namespace {

std::string version() {
  const std::string git = git_description;
  return git.empty() ? std::string(project_version) : fmt::format("{} ({})", project_version, git);
}

std::string compiler() { return fmt::format("g++ {}, {}", __VERSION__, build_type); }

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

}  // namespace

Provenance provenance() { return {version(), compiler(), host_name(), utc_now()}; }

std::map<std::string, std::string> to_texts(const Provenance& provenance) {
  return {{"version", provenance.version},
          {"compiler", provenance.compiler},
          {"host", provenance.host},
          {"date", provenance.date}};
}

std::string version_text() {
  return fmt::format("ddapath {}\ncompiler: {}\nlibraries: {}", version(), compiler(), libraries);
}

std::string utc_now() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(static_cast<std::time_t>(ms / 1000)),
                     ms % 1000);
}

/// VmHWM in KiB. getrusage also knows what the process that started this one held before.
double peak_memory_mib() {
  std::ifstream status("/proc/self/status");
  const std::string name = "VmHWM:";
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name)) return std::stod(line.substr(name.size())) / 1024.0;
  return 0;
}

}  // namespace dda
