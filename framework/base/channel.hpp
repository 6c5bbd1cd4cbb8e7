#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <string_view>

namespace dda {

/// Sends a message with its length through a stream socket; false when nobody listens any more.
bool send_message(int socket, std::string_view message);

/// What came: a message; or none, because the other side has closed, or has said nothing whole in time.
struct Received {
  std::optional<std::string> message;
  bool has_timed_out = false;
};

/// Waits at most so many seconds for a whole message.
Received receive_message(int socket, double seconds);

/// Ends a child process at once and closes the socket that led to it; nothing for a process of -1.
void end_process(pid_t process, int socket);

}  // namespace dda
