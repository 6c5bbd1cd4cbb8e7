#pragma once

#include <csignal>

namespace dda {

/// While it lives, the first Ctrl-C or SIGTERM only sets a flag and the second ends the process at once
/// (130).
///
/// A write beyond the file size limit becomes an error instead of a signal. The handlers of before are put
/// back at the end.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction interrupt_ {
  }, terminate_{}, file_size_{};
};

/// Whether Ctrl-C or SIGTERM came while a guard lived.
bool interrupted();

}  // namespace dda
