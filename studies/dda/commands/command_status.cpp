#include <fmt/format.h>

#include "studies/dda/commands/commands.hpp"
#include "studies/dda/sweep/launch/sweep_status.hpp"

namespace dda {

int sweep_status(const CommandLine& line) {
  const bool is_folder = std::filesystem::is_directory(line.deck);
  fmt::print("{}", sweep_status_text(is_folder ? line.deck : sweep_folder_of(line)));
  return 0;
}

}  // namespace dda
