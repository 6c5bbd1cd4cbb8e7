#pragma once

namespace dda {

/// Reads the command line, does what it asks for, and turns every outcome into an exit code:
///
///     0    the goal was reached            2  the user's input cannot be used
///     3    stopped early, results valid    4  output cannot be written, or an internal error
///     130  interrupted after the restart file was written
int run_command_line(int argc, char** argv);

}  // namespace dda
