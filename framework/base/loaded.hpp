#pragma once

#include <filesystem>

namespace dda {

/// The symbol of a library that is loaded when it is first asked for and stays: what few runs need, all would
/// pay for at their start. Throws std::runtime_error with the loader's words.
void* symbol_of(const std::filesystem::path& library, const char* symbol);

/// A module of this program: beside it when installed there, else where it was built.
std::filesystem::path module_file(const std::filesystem::path& built);

}  // namespace dda
