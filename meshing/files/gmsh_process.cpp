#include "meshing/files/gmsh_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <stdexcept>

#include "framework/base/channel.hpp"
#include "meshing/files/exchange.hpp"
#include "meshing/files/gmsh_server.hpp"

namespace dda {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::runtime_error(
      fmt::format("cannot start a process for gmsh: {}: {}", what, std::strerror(errno)));
}

}  // namespace

GmshProcess::GmshProcess(GmshTask task) : task_(std::move(task)) {
  start();
  try {
    answer();
  } catch (...) {
    end_process(process_, socket_);
    throw;
  }
}

GmshProcess::~GmshProcess() { end_process(process_, socket_); }

void GmshProcess::start() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail("socketpair");
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ == 0) serve_gmsh(ends[1], parent, task_);
  close(ends[1]);
  socket_ = ends[0];
  if (process_ > 0) return;
  close(socket_);
  fail("fork");
}

Layout GmshProcess::layout() const { return unpacked<Layout>(ask(std::string(1, request::layout))); }

Cells GmshProcess::mesh(const ElementWish& wish) const {
  return unpacked<Cells>(ask(request::mesh + packed(wish)));
}

std::string GmshProcess::ask(std::string_view request) const {
  if (!send_message(socket_, request)) fail_ended();
  return answer();
}

std::string GmshProcess::answer() const {
  const auto got = receive_message(socket_, task_.seconds);
  if (got.has_timed_out)
    throw InputError(
        task_.where,
        fmt::format("gmsh was stopped after {:g} s with {}: a loop without end, or a mesh too fine? "
                    "`scene.meshing_seconds` is the limit",
                    task_.seconds, task_.subject));
  if (!got.message) fail_ended();
  const std::string& message = *got.message;
  if (message.empty()) throw std::runtime_error("the process that meshes sent nothing");
  const std::string_view content = std::string_view(message).substr(1);
  if (message[0] == reply::refused) throw InputError(unpacked<std::vector<Finding>>(content));
  if (message[0] == reply::broken) throw std::runtime_error(std::string(content));
  return std::string(content);
}

void GmshProcess::fail_ended() const {
  int status = 0;
  const bool is_known = waitpid(process_, &status, 0) == process_;
  process_ = -1;
  const int signal = is_known && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  const std::string how = signal == SIGKILL ? "was killed, perhaps for want of memory,"
                          : signal != 0     ? fmt::format("crashed ({})", strsignal(signal))
                                            : "ended itself (an Exit in the file, or not enough memory?)";
  throw InputError(task_.where, fmt::format("gmsh {} with {}", how, task_.subject));
}

}  // namespace dda
