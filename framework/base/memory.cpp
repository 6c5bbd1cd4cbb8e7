#include "framework/base/memory.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>

#include "framework/base/errors.hpp"

namespace dda {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double bytes_per_kib = 1024;

/// MemAvailable: free, or given back by caches on demand.
double spare_of_machine() {
  std::ifstream file("/proc/meminfo");
  for (std::string name, unit; file >> name;) {
    double kib = 0;
    if (!(file >> kib)) break;
    std::getline(file, unit);
    if (name == "MemAvailable:") return bytes_per_kib * kib;
  }
  return unlimited;
}

double number_in(const char* path) {
  std::ifstream file(path);
  double value = 0;
  return file >> value ? value : unlimited;
}

/// Of a control group of version 2, as containers are.
double spare_of_container() {
  const double limit = number_in("/sys/fs/cgroup/memory.max");
  if (limit == unlimited) return unlimited;
  const double used = number_in("/sys/fs/cgroup/memory.current");
  return used < limit ? limit - used : 0;
}

double spare_of_shell() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unlimited;
  std::ifstream file("/proc/self/statm");
  double pages = 0;
  file >> pages;
  return std::max(0.0,
                  static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE)));
}

std::optional<double>& given_limit() {
  static std::optional<double> bytes;
  return bytes;
}

}  // namespace

/// RssFile, and malloc's own count.
double held_memory() {
  std::ifstream status("/proc/self/status");
  const std::string name = "RssFile:";
  double libraries = 0;
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name)) libraries = bytes_per_kib * std::stod(line.substr(name.size()));
  const struct mallinfo2 heap = mallinfo2();
  return libraries + static_cast<double>(heap.uordblks + heap.hblkhd);
}

double memory_limit() { return given_limit().value_or(usable_memory()); }
void set_memory_limit(double bytes) { given_limit() = bytes; }
bool has_memory_limit() { return given_limit().has_value(); }

void require_address_space() {
  constexpr double mib = 1024 * 1024, least = 512 * mib;  // OpenBLAS takes 128 MiB for each copy of it
  const double left = spare_of_shell();
  if (left < least)
    throw InputError(
        {}, fmt::format("only {:.0f} MiB of address space are left by `ulimit -v`; a run needs {:.0f}",
                        left / mib, least / mib));
}

double usable_memory() { return std::min({spare_of_machine(), spare_of_container(), spare_of_shell()}); }

}  // namespace dda
