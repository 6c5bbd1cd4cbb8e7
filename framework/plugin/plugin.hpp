#pragma once

#include <filesystem>
#include <vector>

namespace dda {

/// Loads a shared library whose registrations (DDA_REGISTER) add members to families: laws, loads, controls ... from
/// outside the program. It stays loaded; a second call with the same file does nothing. Call it before a deck is read.
///
/// Throws InputError that names the file when there is none, when it is no plugin, was built for another version of the
/// headers or otherwise compiled (stamp.hpp; nothing of it has run then), cannot be loaded, registers a name that is
/// taken, or registers nothing.
void load_plugin(const std::filesystem::path& file);

/// Absolute names of the plugins that are loaded, in their order.
const std::vector<std::filesystem::path>& loaded_plugins();

}  // namespace dda
