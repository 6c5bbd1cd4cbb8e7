#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "continuation/motion/motion.hpp"

namespace dda {

/// Where a motion stands, and how far its files have come.
struct MotionRestart {
  MotionMemory motion;
  int steps = 0;    ///< rows of motion.csv
  int frames = 0;   ///< that were due by then
  int stored = -1;  ///< the last step whose fields are stored
};

/// `deck` tells of what else the next step depends on; a restart is that of the same deck only. Throws OutputError.
void write_motion_restart(const std::filesystem::path& path, const MotionRestart& at,
                          const std::string& deck);

/// Nothing where there is no such file, a damaged one, or one of another deck.
std::optional<MotionRestart> read_motion_restart(const std::filesystem::path& path, const std::string& deck);

}  // namespace dda
