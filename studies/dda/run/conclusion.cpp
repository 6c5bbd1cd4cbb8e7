#include "studies/dda/run/conclusion.hpp"

#include <algorithm>
#include <filesystem>

#include "framework/messages/interrupt.hpp"
#include "studies/dda/figures/model_picture.hpp"

namespace dda {
namespace {

/// Follows the branch that the path has left by switching, if it has, in a folder inside that of the run.
void follow_primary(const DeckFile& deck, const RunFolder& folder, const RunMemory& memory) {
  const bool has_switched =
      std::ranges::any_of(memory.events, [](const auto& event) { return event.contains("switched"); });
  if (!has_switched || interrupted()) return;
  std::vector<std::string> overrides = deck.overrides;
  overrides.emplace_back("path.branch=follow");
  const RunOptions options{.folder = folder.file("primary"), .overwrite = true, .quiet = true};
  run_deck(deck_from_text(deck.text, deck.path, overrides), options);
}

/// The structure as asked, with the loads that have come since the folder was made.
void draw_new_stages(const DeckFile& deck, const RunFolder& folder) {
  if (!std::filesystem::exists(folder.file("model.svg"))) return;  // large structures have none
  Timings timings;
  write_model_picture(folder, Simulation(deck.deck, timings));
}

/// What follows the path where the deck has a motion; how the run ends.
Ending move_on(const FollowedPath& followed, const MotionOptions& options) {
  auto& [deck, folder, simulation, recorder] = followed;
  const auto scope = simulation.system().timings().measure("motion");
  const Walker& walker = simulation.walker();
  const PathEnd end{.equilibrium = simulation.equilibrium(),
                    .state = walker.state(),
                    .history = simulation.system().history(),
                    .is_of_path = true,
                    .has_fallen = simulation.path().stands_in_mechanism() ||
                                  walker.leaving().load_factor * walker.state().load_factor < 0};
  recorder.keep();
  const MotionRecord motion = run_motion(folder, simulation, end, options);
  recorder.add_motion(motion.summary);
  recorder.log().info("motion", motion.summary);
  return motion.ending;
}

/// A mechanism that is not let go could be.
void offer_motion(Simulation& simulation, RunRecorder& recorder) {
  if (simulation.path().stands_in_mechanism() && !simulation.deck().moves())
    recorder.add_notice(
        "The path ends in a mechanism: `path.then: motion` lets it go, in `dda resume` of this run too "
        "(`--set "
        "path.then=motion`); what moves needs a `density`.");
}

}  // namespace

RunResult conclude_run(const FollowedPath& followed, Ending ending, const MotionOptions& options) {
  auto& [deck, folder, simulation, recorder] = followed;
  if (ending.kind != Ending::Kind::interrupted) {
    recorder.end_path(ending);
    follow_primary(deck, folder, recorder.memory());
  }
  if (deck.deck.moves() && ending.kind != Ending::Kind::interrupted)
    if (const Ending moved = move_on(followed, options); moved.kind != Ending::Kind::goal_reached)
      ending = moved;
  offer_motion(simulation, recorder);
  if (recorder.has_new_stages()) draw_new_stages(deck, folder);
  return {folder.path(), ending, recorder.finish(ending), recorder.measures(), recorder.trace()};
}

}  // namespace dda
