#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "framework/files/claims.hpp"

namespace dda {

/// A process that is over.
struct EndedProcess {
  std::size_t id = 0;  ///< as it was started with
  int exit_code = 0;   ///< 128 + number for one that a signal ended, as in a shell
  std::string said;    ///< the end of what it wrote to standard output and standard error
};

/// This very program, as often as there is something to do, or mpirun with so many ranks of it, each with a keeper (keeper.hpp) for its claim.
///
/// Keeper and process have a group of their own, so that the terminal's Ctrl-C reaches them through `stop` alone: a
/// second signal would end the process before it has written its restart file. When this process dies, however it
/// does, the others get SIGTERM. Not thread-safe. Throws OutputError when a process cannot be started.
class Processes {
 public:
  Processes() = default;
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// `arguments` are those behind the program's name; OMP_NUM_THREADS is `threads_of_processes`. The claim is handed
  /// over to the keeper.
  void start(std::size_t id, const std::vector<std::string>& arguments, const Claims& claims, Claim& claim);
  /// One that is over; nothing when none is.
  std::optional<EndedProcess> take_ended();
  /// Asks all of them to end: SIGTERM to the keepers, at which a run writes its restart file.
  void stop();
  std::size_t size() const { return running_.size(); }

 private:
  struct Running {
    std::size_t id;
    pid_t keeper;
    int output;  ///< a file in memory
  };
  std::vector<Running> running_;
};

/// The file of this program.
std::string program_file();

/// How many ranks each of them is; more than one are started by mpirun.
int ranks_of_processes();
void set_ranks_of_processes(int count);

/// What the command line allowed this process, for those that it starts: --trust-geo, --memory-limit, --plugin.
std::vector<std::string> options_of_processes();

/// OMP_NUM_THREADS of processes that run side by side: as it is set, else 1.
std::string threads_of_processes();

}  // namespace dda
