#include <fmt/format.h>

#include "framework/files/whole_file.hpp"
#include "framework/messages/colour.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/run/motion_alone.hpp"
#include "studies/dda/run/one_rank.hpp"
#include "studies/dda/run/recording/profile.hpp"
#include "studies/dda/run/recording/summary.hpp"

namespace dda {
namespace {

/// Whether a run ended by its own rule; then there is nothing to do unless a rule or the control changes.
bool has_reached_goal(const std::filesystem::path& folder) {
  const auto file = folder / "summary.json";
  if (!std::filesystem::exists(file)) return false;
  const auto summary = nlohmann::ordered_json::parse(read_whole(file), nullptr, false);
  return summary.is_object() && summary.value("status", "") == status_of({Ending::Kind::goal_reached, ""});
}

}  // namespace

int command_resume(const CommandLine& line) {
  const std::filesystem::path& folder = line.runs.front();
  if (std::filesystem::exists(folder / "sweep.json")) {
    require_one_rank(folder, "a sweep is shared by the processes of `dda sweep`");
    return resume_sweep(line);
  }
  if (line.overrides.empty() && has_reached_goal(folder)) {
    fmt::print("{}: goal_reached before; `--set` another stopping rule or control to go on\n",
               folder.string());
    return 0;
  }
  if (is_motion_alone(folder)) {
    require_one_rank(folder, "a motion without a path is computed by one process");
    const MotionResult moved = resume_motion_alone(folder, line.overrides, line.run);
    const int code = exit_code_of(moved.ending);
    fmt::print("{}\n", coloured_end(last_line(moved), code, stdout));
    return code;
  }
  const RunResult result = resume_run(folder, line.overrides, line.run);
  if (line.run.profile) fmt::print("{}", profile_table(result.summary));
  const int code = exit_code_of(result.ending);
  fmt::print("{}\n", coloured_end(last_line(result), code, stdout));
  return code;
}

}  // namespace dda
