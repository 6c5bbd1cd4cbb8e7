#pragma once

#include <sys/types.h>

#include "framework/files/claims.hpp"

namespace dda {

/// What a keeper starts and keeps.
struct KeptProcess {
  /// The running program is /proc/self/exe even when its file has been replaced in the meantime; others are looked up.
  const char* file = nullptr;
  char* const* words = nullptr;  ///< program and arguments, as execv wants them
  int end_signal = 0;            ///< at which it ends with a restart file
  int output = -1;               ///< where it writes to
  pid_t parent = 0;              ///< of the keeper
  ClaimFiles claim;
  double between_beats = 0;  ///< [s]
};

/// Exit code of a keeper whose claim another process has taken over, its own process having been ended; EX_TEMPFAIL
/// of sysexits.h, which no run ends with.
constexpr int exit_code_of_lost_claim = 75;

/// Exit code for what waitpid says of a process: 128 + number for one that a signal ended, as in a shell.
int exit_code_of_status(int status);

/// A process between a sweep and one of its runs: it starts the run, gives signs of life for its claim while the run
/// lives, and ends with the run's exit code.
///
/// So the claim lives as long as the run, also when the sweep is stopped (Ctrl-Z) or dies: then the run is asked to
/// end (SIGTERM), writes its restart file, and nobody takes the case over before. A run whose keeper dies, or whose
/// claim is lost, is killed, since it might write where another one does. For the child of a fork: calls only what
/// is allowed between fork and exec, see signal-safety(7).
[[noreturn]] void keep(const KeptProcess& kept);

}  // namespace dda
