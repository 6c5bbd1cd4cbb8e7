#include "framework/messages/interrupt.hpp"

#include <unistd.h>

namespace dda {
namespace {

constexpr int exit_code_interrupted = 130;
constexpr std::array interrupting{SIGINT, SIGTERM, SIGUSR1, SIGUSR2};
volatile std::sig_atomic_t flag = 0;

volatile std::sig_atomic_t ends_at_once = 0;

void on_signal(int signal) {
  const bool is_impatient = flag != 0 && signal == SIGINT;
  if (is_impatient || ends_at_once != 0) _exit(exit_code_interrupted);
  flag = 1;
}

}  // namespace

InterruptGuard::InterruptGuard(OnInterrupt first) {
  flag = 0;
  ends_at_once = first == OnInterrupt::end ? 1 : 0;
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  for (std::size_t i = 0; i < interrupting.size(); ++i) sigaction(interrupting[i], &action, &before_[i]);
  action.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &action, &file_size_);
}

InterruptGuard::~InterruptGuard() {
  for (std::size_t i = 0; i < interrupting.size(); ++i) sigaction(interrupting[i], &before_[i], nullptr);
  sigaction(SIGXFSZ, &file_size_, nullptr);
}

void InterruptGuard::set_flag_first() { ends_at_once = 0; }

bool interrupted() { return flag != 0; }

}  // namespace dda
