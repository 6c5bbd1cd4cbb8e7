#include "studies/dda/sweep/processes/processes.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
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
#include "framework/plugin/plugin.hpp"
#include "meshing/files/gmsh_model.hpp"
#include "studies/dda/sweep/processes/keeper.hpp"

namespace dda {
namespace {

constexpr off_t longest_output = 64 * 1024;
constexpr double beats_per_lease = 6;

[[noreturn]] void fail(const char* what) {
  throw OutputError(fmt::format("cannot start a process: {}: {}", what, std::strerror(errno)));
}

int& rank_count() {
  static int count = 1;
  return count;
}

/// Several mpirun on one machine would bind their ranks to the same processors.
std::vector<std::string> line_of(const std::vector<std::string>& arguments) {
  std::vector<std::string> out;
  if (rank_count() > 1) out = {"mpirun", "--quiet", "--bind-to", "none", "-n", std::to_string(rank_count())};
  out.push_back(program_file());
  out.insert(out.end(), arguments.begin(), arguments.end());
  return out;
}

/// As execv wants them.
std::vector<char*> words_of(const std::vector<std::string>& line) {
  std::vector<char*> words;
  for (const std::string& word : line) words.push_back(const_cast<char*>(word.c_str()));
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

/// A new process that does something and does not come back; negative when there is none. It begins with SIGTERM blocked,
/// or one that comes before it is ready would be lost in this process's handler.
template <class Task>
pid_t forked(const Task& task) {
  sigset_t terminate, before;
  sigemptyset(&terminate);
  sigaddset(&terminate, SIGTERM);
  sigprocmask(SIG_BLOCK, &terminate, &before);
  const pid_t process = fork();
  if (process == 0) task();
  sigprocmask(SIG_SETMASK, &before, nullptr);
  return process;
}

}  // namespace

Processes::~Processes() {
  stop();
  for (const Running& one : running_) {
    waitpid(one.keeper, nullptr, 0);
    close(one.output);
  }
}

void Processes::start(std::size_t id, const std::vector<std::string>& arguments, const Claims& claims,
                      Claim& claim) {
  setenv("OMP_NUM_THREADS", threads_of_processes().c_str(), 1);
  const std::vector<std::string> line = line_of(arguments);
  const std::vector<char*> words = words_of(line);
  const int output = memfd_create("output", MFD_CLOEXEC);
  if (output < 0) fail("memfd_create");
  const bool is_alone = rank_count() == 1;  // mpirun passes SIGUSR1 on, and gives time after it
  const KeptProcess kept{.file = is_alone ? "/proc/self/exe" : line.front().c_str(),
                         .words = words.data(),
                         .end_signal = is_alone ? SIGTERM : SIGUSR1,
                         .output = output,
                         .parent = getpid(),
                         .claim = claims.files_of(claim),
                         .between_beats = claim.lease / beats_per_lease};
  const pid_t keeper = forked([&] { keep(kept); });
  if (keeper < 0) {
    close(output);
    fail("fork");
  }
  running_.push_back({id, keeper, output});
  claims.hand_over(claim, keeper);
}

std::optional<EndedProcess> Processes::take_ended() {
  for (auto one = running_.begin(); one != running_.end(); ++one) {
    int status = 0;
    if (waitpid(one->keeper, &status, WNOHANG) != one->keeper) continue;
    EndedProcess out{one->id, exit_code_of_status(status), end_of(one->output)};
    close(one->output);
    running_.erase(one);
    return out;
  }
  return {};
}

void Processes::stop() {
  for (const Running& one : running_) kill(one.keeper, SIGTERM);
}

int ranks_of_processes() { return rank_count(); }
void set_ranks_of_processes(int count) { rank_count() = count; }

std::string program_file() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

std::vector<std::string> options_of_processes() {
  std::vector<std::string> out;
  if (trusts_geo()) out.emplace_back("--trust-geo");
  if (has_memory_limit())
    out.push_back(fmt::format("--memory-limit={:.17g}", memory_limit() / bytes_per_gib));
  for (const std::filesystem::path& plugin : loaded_plugins()) out.push_back("--plugin=" + plugin.string());
  return out;
}

std::string threads_of_processes() {
  const char* const set = std::getenv("OMP_NUM_THREADS");
  return set ? set : "1";
}

}  // namespace dda
