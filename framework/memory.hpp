#pragma once

namespace dda {

/// Memory that this process may still take [bytes]: what the machine has to spare, within what a container
/// and the shell (ulimit -v) allow.
double usable_memory();

}  // namespace dda
