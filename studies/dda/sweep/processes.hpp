#pragma once

#include <sys/types.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dda {

/// A process that is over.
struct EndedProcess {
  std::size_t id = 0;  ///< as it was started with
  int exit_code = 0;   ///< 128 + number for one that a signal ended, as in a shell
  std::string said;    ///< the end of what it wrote to standard output and standard error
};

/// This very program, as often as there is something to do.
///
/// Each process has a group of its own, so that the terminal's Ctrl-C reaches it through `stop` alone: a
/// second signal would end it before it has written its restart file. When this process dies, however it
/// does, the others get SIGTERM. Not thread-safe. Throws OutputError when a process cannot be started.
class Processes {
 public:
  Processes() = default;
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// `arguments` are those behind the program's name; OMP_NUM_THREADS is `threads_of_processes`.
  void start(std::size_t id, const std::vector<std::string>& arguments);
  /// One that is over; nothing when none is.
  std::optional<EndedProcess> take_ended();
  /// Asks all of them to end: SIGTERM, at which a run writes its restart file.
  void stop();
  std::size_t size() const { return running_.size(); }

 private:
  struct Running {
    std::size_t id;
    pid_t process;
    int output;  ///< a file in memory
  };
  std::vector<Running> running_;
};

/// This process goes on as this very program with other arguments, OMP_NUM_THREADS being
/// `threads_of_processes`. Throws OutputError when it cannot.
[[noreturn]] void become(const std::vector<std::string>& arguments);

/// The file of this program.
std::string program_file();

/// What the command line allowed this process, for those that it starts: --trust-geo, --memory-limit.
std::vector<std::string> options_of_processes();

/// OMP_NUM_THREADS of processes that run side by side: as it is set, else 1.
std::string threads_of_processes();

}  // namespace dda
