#pragma once

#include <functional>

namespace dda {

/// Does what the command line asks for as the processes of an MPI launcher, if this is one of several: `run` and
/// `resume` share one run, rank 0 does what the command says and the others help it; each process of a `sweep` does
/// cases of its own; no other command is for several. Returns the exit code.
int on_all_ranks(int argc, char** argv, const std::function<int()>& command);

}  // namespace dda
