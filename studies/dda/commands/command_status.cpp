#include <fmt/format.h>

#include "framework/base/errors.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/sweep/launch/sweep_status.hpp"

namespace dda {

int sweep_status(const CommandLine& line) {
  const bool is_folder = std::filesystem::is_directory(line.deck);
  const std::filesystem::path folder = is_folder ? line.deck : sweep_folder_of(line);
  if (!std::filesystem::exists(line.deck) && !std::filesystem::exists(folder / "sweep.json"))
    throw InputError(
        Position{line.deck.string()},
        "there is no such file or folder; `dda sweep --status` takes the file of a sweep or its folder");
  fmt::print("{}", sweep_status_text(folder));
  return 0;
}

}  // namespace dda
