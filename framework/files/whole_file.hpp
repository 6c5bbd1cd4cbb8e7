#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace dda {

/// How far a written file must have got: to_disk survives a power failure, to_system only a killed process.
enum class Flush { to_disk, to_system };

/// Writes the whole text or nothing: aside (`.part`), flushed, then renamed over `path`.
/// Throws OutputError (file, reason); an older file of that name is then left as it was.
void write_whole(const std::filesystem::path& path, std::string_view text, Flush flush = Flush::to_disk);

/// The same for a file that other processes, also of other machines, may be writing at this time: the last one's stays.
/// It reaches the operating system.
void write_shared(const std::filesystem::path& path, std::string_view text);

/// A file of the disk, neither folder nor device nor pipe, whose reading may never end. Throws InputError naming
/// it when it cannot be read.
std::ifstream open_for_reading(const std::filesystem::path& path);

/// The whole content of a file. Throws InputError naming it when it cannot be read.
std::string read_whole(const std::filesystem::path& path);

}  // namespace dda
