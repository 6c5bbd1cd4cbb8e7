#pragma once

#include <filesystem>

#include "framework/files/claims.hpp"
#include "studies/dda/sweep/sweep_folder.hpp"

namespace dda {

/// How a process comes to a sweep's folder.
struct Entrance {
  bool overwrite = false;  ///< throws away what is there
  double lease = 60;       ///< of its claims [s]
};

/// The folder of the claims on a sweep's cases. Its name follows from all effective decks in their order, so that
/// processes with different sweeps never take each other's numbers for theirs.
std::filesystem::path claims_folder(const std::filesystem::path& folder, const Sweep& sweep);

/// Makes a sweep's folder ready, or joins the processes that are at work there; the claims on its cases.
///
/// Runs of an earlier form of the sweep are moved to where their cases belong, by one process at a time. Throws
/// InputError when that, or throwing all away, would disturb runs of other processes, or lose runs; OutputError where
/// the folder cannot be written.
Claims enter_sweep(const std::filesystem::path& folder, const Sweep& sweep, const Entrance& entrance);

}  // namespace dda
