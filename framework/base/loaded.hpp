#pragma once

#include <filesystem>

namespace dda {

/// The symbol of a library that is loaded when it is first asked for and stays: what few runs need, all would
/// pay for at their start. Throws std::runtime_error with the loader's words.
void* symbol_of(const std::filesystem::path& library, const char* symbol);

/// The folder above that of this program: what it was built or installed into, wherever that has been moved. Where this code
/// is a library of Python, the folder above lib/ddapath, in which that lies.
std::filesystem::path installation();

/// A module of this program, such as "dda_gmsh.so": lib/ddapath below `installation()`.
std::filesystem::path module_file(const char* name);

}  // namespace dda
