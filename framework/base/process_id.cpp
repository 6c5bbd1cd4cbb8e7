#include "framework/base/process_id.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

namespace dda {
namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// Names of machines and the random number of a boot can both come twice, with copied images; containers of one
/// boot have numbers of processes of their own.
std::string machine_name() {
  std::string boot;
  std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), boot);
  std::error_code error;
  const std::string numbers = std::filesystem::read_symlink("/proc/self/ns/pid", error).string();
  return boot.empty() || error ? "" : fmt::format("{} {} {}", host_name(), boot, numbers);
}

const std::string& this_machine() {
  static const std::string name = machine_name();
  return name;
}

struct ProcessEntry {
  char state = ' ';
  std::uint64_t start = 0;
};

/// From /proc; nothing when it is not there or hidden from this user.
std::optional<ProcessEntry> entry_of(std::int64_t process) {
  constexpr int fields_before_start = 18;  // between the state, field 3, and field 22
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  std::string text;
  if (!std::getline(file, text)) return {};
  std::istringstream fields(text.substr(text.rfind(')') + 1));  // the name may hold anything
  ProcessEntry out;
  fields >> out.state;
  std::string skipped;
  for (int i = 0; i < fields_before_start; ++i) fields >> skipped;
  fields >> out.start;
  return out;
}

}  // namespace

ProcessId id_of(pid_t process) {
  const auto entry = entry_of(process);
  return {host_name(), this_machine(), process, entry ? entry->start : 0};
}

bool is_of_this_machine(const ProcessId& process) {
  return process.number > 0 && !this_machine().empty() && process.machine == this_machine();
}

bool is_alive(const ProcessId& process) {
  if (kill(static_cast<pid_t>(process.number), 0) != 0 && errno != EPERM) return false;
  const auto entry = entry_of(process.number);
  if (!entry) return true;
  return entry->state != 'Z' && entry->state != 'X' && (process.start == 0 || entry->start == process.start);
}

}  // namespace dda
