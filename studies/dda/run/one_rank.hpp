#pragma once

#include <filesystem>

namespace dda {

/// Throws InputError, about a file or folder, where several ranks have been started for what one process does.
void require_one_rank(const std::filesystem::path& of, const char* what);

}  // namespace dda
