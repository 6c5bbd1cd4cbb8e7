#include "studies/dda/sweep/processes/keeper.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <ctime>

namespace dda {
namespace {

constexpr int exit_code_not_started = 127;

/// Those that a keeper waits for.
sigset_t awaited_signals() {
  sigset_t out;
  sigemptyset(&out);
  sigaddset(&out, SIGTERM);
  sigaddset(&out, SIGCHLD);
  return out;
}

/// Gets `signal` when its parent dies, however that does.
void die_with(pid_t parent, int signal) {
  prctl(PR_SET_PDEATHSIG, signal);
  if (getppid() != parent) _exit(exit_code_not_started);  // it died before the line above
}

[[noreturn]] void begin(const KeptProcess& kept, pid_t keeper) {
  die_with(keeper, SIGKILL);
  const sigset_t awaited = awaited_signals();
  sigprocmask(SIG_UNBLOCK, &awaited, nullptr);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(kept.output, STDOUT_FILENO);
  dup2(kept.output, STDERR_FILENO);
  execvp(kept.file, kept.words);
  _exit(exit_code_not_started);
}

timespec time_of(double seconds) {
  const auto whole = static_cast<time_t>(seconds);
  return {whole, static_cast<long>((seconds - static_cast<double>(whole)) * 1e9)};
}

[[noreturn]] void give_up(pid_t run) {
  kill(run, SIGKILL);
  waitpid(run, nullptr, 0);
  _exit(exit_code_of_lost_claim);
}

}  // namespace

int exit_code_of_status(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

void keep(const KeptProcess& kept) {
  setpgid(0, 0);
  const sigset_t awaited = awaited_signals();
  sigprocmask(SIG_BLOCK, &awaited, nullptr);
  die_with(kept.parent, SIGTERM);
  const pid_t keeper = getpid();
  const pid_t run = fork();
  if (run == 0) begin(kept, keeper);
  if (run < 0) _exit(exit_code_not_started);
  const timespec pause = time_of(kept.between_beats);
  for (std::uint64_t beats = 2;; ++beats) {
    if (sigtimedwait(&awaited, nullptr, &pause) == SIGTERM) kill(run, kept.end_signal);
    int status = 0;
    if (waitpid(run, &status, WNOHANG) == run) _exit(exit_code_of_status(status));
    if (!beat(kept.claim, beats)) give_up(run);
  }
}

}  // namespace dda
