#include "studies/dda/sweep/processes.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "framework/base/errors.hpp"
#include "framework/base/memory.hpp"
#include "meshing/files/gmsh_model.hpp"

namespace dda {
namespace {

constexpr off_t longest_output = 64 * 1024;
constexpr int exit_code_not_started = 127;

[[noreturn]] void fail(const char* what) {
  throw OutputError(fmt::format("cannot start a process: {}: {}", what, std::strerror(errno)));
}

/// What happens in the new process; only what is allowed between fork and exec, see signal-safety(7).
/// /proc/self/exe is the running program even when its file has been replaced in the meantime.
[[noreturn]] void begin_child(char* const* arguments, int output, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(exit_code_not_started);  // it died before the line above
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execv("/proc/self/exe", arguments);
  _exit(exit_code_not_started);
}

/// As execv wants them.
std::vector<char*> words_of(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  return words;
}

std::string end_of(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::min(size, longest_output)), '\0');
  const ssize_t read = pread(file, text.data(), text.size(), std::max<off_t>(0, size - longest_output));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(read, 0)));
  return text;
}

int exit_code_of(int status) { return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status); }

}  // namespace

Processes::~Processes() {
  stop();
  for (const Running& one : running_) {
    waitpid(one.process, nullptr, 0);
    close(one.output);
  }
}

void Processes::start(std::size_t id, const std::vector<std::string>& arguments) {
  setenv("OMP_NUM_THREADS", threads_of_processes().c_str(), 1);
  const std::string program = program_file();
  const std::vector<char*> words = words_of(program, arguments);
  const int output = memfd_create("output", MFD_CLOEXEC);
  if (output < 0) fail("memfd_create");
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process == 0) begin_child(words.data(), output, parent);
  if (process < 0) {
    close(output);
    fail("fork");
  }
  running_.push_back({id, process, output});
}

std::optional<EndedProcess> Processes::take_ended() {
  for (auto one = running_.begin(); one != running_.end(); ++one) {
    int status = 0;
    if (waitpid(one->process, &status, WNOHANG) != one->process) continue;
    EndedProcess out{one->id, exit_code_of(status), end_of(one->output)};
    close(one->output);
    running_.erase(one);
    return out;
  }
  return {};
}

void Processes::stop() {
  for (const Running& one : running_) kill(one.process, SIGTERM);
}

void become(const std::vector<std::string>& arguments) {
  setenv("OMP_NUM_THREADS", threads_of_processes().c_str(), 1);
  const std::string program = program_file();
  execv("/proc/self/exe", words_of(program, arguments).data());
  fail("execv");
}

std::string program_file() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

std::vector<std::string> options_of_processes() {
  std::vector<std::string> out;
  if (trusts_geo()) out.emplace_back("--trust-geo");
  if (has_memory_limit())
    out.push_back(fmt::format("--memory-limit={:.17g}", memory_limit() / bytes_per_gib));
  return out;
}

std::string threads_of_processes() {
  const char* const set = std::getenv("OMP_NUM_THREADS");
  return set ? set : "1";
}

}  // namespace dda
