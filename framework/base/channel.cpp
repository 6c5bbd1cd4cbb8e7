#include "framework/base/channel.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>

namespace dda {
namespace {

using Clock = std::chrono::steady_clock;

bool send_bytes(int socket, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = write(socket, bytes, count);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// A write to a closed socket is an error, not a signal, while it lives.
class NoPipeSignal {
 public:
  NoPipeSignal() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~NoPipeSignal() { std::signal(SIGPIPE, before_); }

 private:
  void (*before_)(int);
};

/// Reads until a moment.
class Reader {
 public:
  Reader(int socket, Clock::time_point until) : socket_(socket), until_(until) {}

  bool read_bytes(char* bytes, std::size_t count) {
    while (count > 0) {
      if (!wait()) return false;
      const ssize_t got = read(socket_, bytes, count);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      bytes += got;
      count -= static_cast<std::size_t>(got);
    }
    return true;
  }
  bool has_timed_out() const { return has_timed_out_; }

 private:
  bool wait() {
    for (;;) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until_ - Clock::now()).count();
      if (left <= 0) return has_timed_out_ = true, false;
      constexpr long long longest = 1'000'000;
      pollfd one{socket_, POLLIN, 0};
      if (poll(&one, 1, static_cast<int>(std::min<long long>(left, longest))) > 0) return true;
    }
  }

  int socket_;
  Clock::time_point until_;
  bool has_timed_out_ = false;
};

}  // namespace

bool send_message(int socket, std::string_view message) {
  const NoPipeSignal guard;
  const std::size_t size = message.size();
  return send_bytes(socket, reinterpret_cast<const char*>(&size), sizeof size) &&
         send_bytes(socket, message.data(), size);
}

Received receive_message(int socket, double seconds) {
  const auto time = std::chrono::duration<double>(std::min(seconds, 1e9));
  Reader reader(socket, Clock::now() + std::chrono::duration_cast<Clock::duration>(time));
  std::size_t size = 0;
  std::string message;
  if (!reader.read_bytes(reinterpret_cast<char*>(&size), sizeof size)) return {{}, reader.has_timed_out()};
  constexpr std::size_t piece = 1 << 24;  // a length is not believed before as much has come
  for (std::size_t at = 0; at < size; at = message.size()) {
    message.resize(at + std::min(piece, size - at));
    if (!reader.read_bytes(message.data() + at, message.size() - at)) return {{}, reader.has_timed_out()};
  }
  return {std::move(message), false};
}

void end_process(pid_t process, int socket) {
  if (process > 0) {
    kill(process, SIGKILL);
    while (waitpid(process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (socket >= 0) close(socket);
}

}  // namespace dda
