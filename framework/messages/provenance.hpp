#pragma once

#include <map>
#include <string>

namespace dda {

/// Where a result comes from.
struct Provenance {
  std::string version;   ///< project version, followed by git's description when built from a repository
  std::string compiler;  ///< name, version and build type
  std::string host;      ///< name of the machine
  std::string date;      ///< UTC, ISO 8601
};

Provenance provenance();

/// The same as named texts, as results hold them.
std::map<std::string, std::string> to_texts(const Provenance& provenance);

/// What `dda --version` prints: project version and commit, compiler, and the libraries that it was built with.
std::string version_text();

/// UTC now with milliseconds: "2024-05-01T12:00:00.123Z".
std::string utc_now();

/// The most memory this process has held [MiB].
double peak_memory_mib();

}  // namespace dda
