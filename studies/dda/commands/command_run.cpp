#include <fmt/format.h>

#include "framework/messages/colour.hpp"
#include "studies/dda/case/deck/deck_tree.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/run/motion_alone.hpp"
#include "studies/dda/run/one_rank.hpp"
#include "studies/dda/run/recording/profile.hpp"
#include "studies/dda/run/recording/summary.hpp"
#include "studies/dda/sweep/description/sweep.hpp"

namespace dda {

int command_run(const CommandLine& line) {
  DeckSource source = read_source(line.deck);
  if (is_sweep(DeckTree(source.root).root(), line.overrides)) {
    require_one_rank(line.deck, "a sweep is shared by the processes of `dda sweep`");
    return command_sweep(line);
  }
  const DeckFile deck = read_deck(std::move(source), line.overrides);
  if (!deck.deck.has_path()) {
    require_one_rank(line.deck, "a motion without a path is computed by one process");
    const MotionResult moved = run_motion_alone(deck, line.run);
    const int code = exit_code_of(moved.ending);
    fmt::print("{}\n", coloured_end(last_line(moved), code, stdout));
    return code;
  }
  const RunResult result = run_deck(deck, line.run);
  if (line.run.profile) fmt::print("{}", profile_table(result.summary));
  const int code = exit_code_of(result.ending);
  fmt::print("{}\n", coloured_end(last_line(result), code, stdout));
  return code;
}

}  // namespace dda
