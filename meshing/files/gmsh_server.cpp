#include "meshing/files/gmsh_server.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>

#include "framework/base/channel.hpp"
#include "framework/base/loaded.hpp"
#include "framework/base/memory.hpp"
#include "meshing/files/exchange.hpp"

namespace dda {
namespace {

const GmshModule& module() {
  static const auto* loaded =
      static_cast<const GmshModule*>(symbol_of(module_file("dda_gmsh.so"), "dda_gmsh_module"));
  return *loaded;
}

[[noreturn]] void quit() { _exit(0); }

std::string refusal(const Position& where, const std::string& what) {
  return reply::refused + packed(std::vector<Finding>{{where, what}});
}

/// What `work` gives, or why it does not.
std::string answer_of(const GmshTask& task, const std::function<std::string()>& work) {
  try {
    return reply::done + work();
  } catch (const InputError& error) {
    return reply::refused + packed(error.findings());
  } catch (const std::bad_alloc&) {
    return refusal(task.where, "gmsh has not enough memory for " + task.subject);
  } catch (const std::exception& error) {
    return refusal(task.where, fmt::format("gmsh failed with {}: {}", task.subject, error.what()));
  } catch (const std::string& message) {  // which gmsh throws
    return refusal(task.where, fmt::format("gmsh failed with {}: {}", task.subject, message));
  } catch (...) {
    return refusal(task.where, "gmsh failed with " + task.subject);
  }
}

void set_limit(__rlimit_resource resource, rlim_t value) {
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_max = limit.rlim_cur = std::min(value, limit.rlim_max);
  setrlimit(resource, &limit);
}

/// No file to write to, no core file, a deep stack as gmsh would have, and no more memory than half of what
/// there is; sanitizers need address space of their own, and to speak.
void set_limits(bool is_confined) {
  if (is_confined) set_limit(RLIMIT_FSIZE, 0);
  std::signal(SIGXFSZ, SIG_IGN);  // gmsh tries to write preferences as it starts
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_STACK, rlim_t{1} << 30);
#ifndef __SANITIZE_ADDRESS__
  constexpr double of_libraries = 2e9;
  set_limit(RLIMIT_AS, static_cast<rlim_t>(std::min(usable_memory() / 2 + of_libraries, 1e18)));
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nothing, stream);
#endif
}

/// The socket as the one open file beside the three standard ones.
int keep_only(int socket) {
  constexpr int kept = STDERR_FILENO + 1;
  dup2(socket, kept);
  close_range(kept + 1, std::numeric_limits<unsigned>::max(), 0);
  return kept;
}

/// The signals of the terminal end this process with the one that waits for it.
void leave_parent(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) quit();
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) std::signal(signal, SIG_DFL);
  std::atexit(quit);  // a file that says Exit must not run what the parent does at its end
}

std::string answer_to(const std::string& request, const GmshModel& model) {
  if (request[0] == request::mesh) return packed(model.mesh(unpacked<ElementWish>(request.substr(1))));
  return packed(model.layout());
}

}  // namespace

void serve_gmsh(int socket, pid_t parent, const GmshTask& task) {
  leave_parent(parent);
  socket = keep_only(socket);
  try {
    module();
  } catch (const std::exception& error) {
    send_message(socket, reply::broken + std::string(error.what()));
    quit();
  }
  set_limits(task.is_confined);
  std::shared_ptr<const GmshModel> model;
  const std::string opened = answer_of(task, [&] {
    if (task.is_confined) module().confine(task.folders);
    model = task.open(module());
    return std::string();
  });
  if (!send_message(socket, opened) || !model) quit();
  for (;;) {
    const auto got = receive_message(socket, std::numeric_limits<double>::infinity());
    if (!got.message || got.message->empty()) quit();
    if (!send_message(socket, answer_of(task, [&] { return answer_to(*got.message, *model); }))) quit();
  }
}

}  // namespace dda
