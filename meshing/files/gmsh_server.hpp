#pragma once

#include <sys/types.h>

#include "meshing/files/gmsh_process.hpp"

namespace dda {

/// First letter of what a GmshProcess asks, and of what it is told.
namespace request {
constexpr char layout = 'L', mesh = 'M';
}
namespace reply {
constexpr char done = 'D', refused = 'R', broken = 'B';
}

/// The other side of a GmshProcess, after the fork: opens the task's model and answers until nobody asks.
[[noreturn]] void serve_gmsh(int socket, pid_t parent, const GmshTask& task);

}  // namespace dda
