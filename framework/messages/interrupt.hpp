#pragma once

#include <array>
#include <csignal>

namespace dda {

/// What the first Ctrl-C, SIGTERM, SIGUSR1 or SIGUSR2 (which mpirun passes on, and batch queues send ahead of the end)
/// does: end the process at once, while there is nothing to be kept, or set
/// a flag that is looked at between steps.
enum class OnInterrupt { end, flag };

/// While it lives, the first of these signals does as it is told, and a further Ctrl-C ends the process at once
/// (130). SIGTERM comes more than once where a batch queue ends all processes of a sweep, each of which ends its own.
///
/// A write beyond the file size limit becomes an error instead of a signal. The handlers of before are put
/// back at the end.
class InterruptGuard {
 public:
  explicit InterruptGuard(OnInterrupt first = OnInterrupt::flag);
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  /// From here on the first signal sets the flag.
  void set_flag_first();

 private:
  std::array<struct sigaction, 4> before_{};
  struct sigaction file_size_ {};
};

/// Whether one of them came while a guard lived.
bool interrupted();

}  // namespace dda
