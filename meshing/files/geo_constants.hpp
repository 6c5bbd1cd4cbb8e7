#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace dda {

/// Variables that a .geo file, or one that it includes, lets others set: those of its DefineConstant[...]. Empty where the
/// file cannot be read.
std::set<std::string> constants_of_geometry(const std::filesystem::path& file);

}  // namespace dda
