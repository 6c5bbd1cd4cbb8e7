#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "framework/files/whole_file.hpp"

namespace dda {

/// Everything needed to continue a run, as named arrays; the names are the caller's.
struct RestartData {
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::vector<std::int64_t>> integers;
  std::map<std::string, std::vector<std::string>> texts;

  friend bool operator==(const RestartData&, const RestartData&) = default;
};

/// Writes the whole file or nothing (aside, renamed), with a format version and a checksum.
/// Throws OutputError (file, reason).
void write_restart(const std::filesystem::path& path, const RestartData& data, Flush flush = Flush::to_disk);

/// Reads the values back bit for bit. Throws InputError naming the file when it is missing, truncated,
/// changed or not a restart file.
RestartData read_restart(const std::filesystem::path& path);

}  // namespace dda
