#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

namespace dda {

/// A process as any machine can name it.
struct ProcessId {
  std::string host;         ///< name of its machine, for people
  std::string machine;      ///< one boot of one machine or container, within which `number` means something
  std::int64_t number = 0;  ///< 0: not known
  std::uint64_t start = 0;  ///< clock ticks after that boot (proc(5), field 22): numbers come again
};

/// Of a process of this machine.
ProcessId id_of(pid_t process);

/// Whether `process` is one of this machine, of which `is_alive` can tell.
bool is_of_this_machine(const ProcessId& process);

/// Of a process of this machine: neither gone nor waiting to be forgotten (a zombie).
bool is_alive(const ProcessId& process);

}  // namespace dda
