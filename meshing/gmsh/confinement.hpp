#pragma once

#include <filesystem>
#include <vector>

namespace dda {

/// From here on this process may compute, read below the given folders, and answer through the files that it
/// has open; it starts no program, writes to no other file, and knows no network. Cannot be taken back.
///
/// Landlock keeps it to the folders, seccomp to the system calls; what the kernel does not have is left out.
void confine(const std::vector<std::filesystem::path>& folders);

}  // namespace dda
