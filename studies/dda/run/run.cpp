#include "studies/dda/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "framework/base/memory.hpp"
#include "framework/files/run/results.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/interrupt.hpp"
#include "studies/dda/figures/model_picture.hpp"
#include "studies/dda/run/motion_run.hpp"
#include "studies/dda/run/new_run.hpp"
#include "studies/dda/run/restart.hpp"
#include "studies/dda/run/summary.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

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

constexpr auto out_of_range = "the numbers of the next step are too large or too small to compute with";

bool is_finite(const Candidate& at) {
  return std::ranges::all_of(std::array{at.state.load_factor, at.load, at.stored, at.dissipated, at.work},
                             [](double x) { return std::isfinite(x); });
}

/// Follows the path to its end.
Ending follow(Simulation& simulation, RunRecorder& recorder, bool quiet) {
  Progress progress = Progress::for_stream(stderr, quiet);
  const auto scope = simulation.system().timings().measure("path");
  Path& path = simulation.path();
  path.interrupt_when(interrupted);
  for (const Point& point : path) {
    if (!is_finite(simulation.walker().here())) return {Ending::Kind::stopped_early, out_of_range};
    recorder.record(point);
    if (const std::string warning = recorder.take_warning(); !warning.empty()) progress.note(warning);
    progress.show(recorder.progress());
  }
  progress.finish();
  return path.ending();
}

bool is_reached(const Ending& ending) { return ending.kind == Ending::Kind::goal_reached; }

/// What follows the path where the deck has a motion; how the run ends.
Ending move_on(const RunFolder& folder, Simulation& simulation, RunRecorder& recorder,
               const MotionOptions& options) {
  const auto scope = simulation.system().timings().measure("motion");
  const Walker& walker = simulation.walker();
  const PathEnd end{.equilibrium = simulation.equilibrium(),
                    .state = walker.state(),
                    .history = simulation.system().history(),
                    .is_of_path = true,
                    .has_fallen = simulation.path().memory().is_mechanism ||
                                  walker.leaving().load_factor * walker.state().load_factor < 0};
  const MotionRecord motion = run_motion(folder, simulation, end, options);
  recorder.add_motion(motion.summary);
  recorder.log().info("motion", motion.summary);
  return motion.ending;
}

/// A mechanism that is not let go could be.
void offer_motion(Simulation& simulation, RunRecorder& recorder) {
  if (simulation.path().memory().is_mechanism && !simulation.deck().moves())
    recorder.add_notice(
        "The path ends in a mechanism: `path.then: motion` lets it go, in `dda resume` of this run too "
        "(`--set "
        "path.then=motion`); what moves needs a `density`.");
}

RunResult conclude(const RunFolder& folder, RunRecorder& recorder, const Ending& ending) {
  return {folder.path(), ending, recorder.finish(ending), recorder.measures(), recorder.trace()};
}

/// The files that a continued run goes on with.
void copy_run(const fs::path& from, const RunFolder& to) {
  for (const char* name :
       {"curve.csv", "curve.units.json", "log.jsonl", "model.svg", fields_folder, "run.xdmf", "restart.h5"}) {
    std::error_code error;
    fs::copy(from / name, to.file(name), fs::copy_options::overwrite_existing | fs::copy_options::recursive,
             error);
    if (error)
      throw OutputError(fmt::format("cannot copy '{}': {}", (from / name).string(), error.message()));
  }
  copy_motion(from, to);
}

/// A run that was killed in its first second has left a deck and no more.
void require_restart(const RunFolder& folder) {
  std::error_code error;
  if (fs::exists(folder.file("restart.h5"), error) || !fs::exists(folder.file("effective_deck.yaml"), error))
    return;
  throw InputError(
      Position{folder.path().string()},
      fmt::format("the run ended before its first restart file; `dda run DECK --folder {} --overwrite` "
                  "starts it again",
                  folder.path().string()));
}

/// The conclusions of a run that goes on are not those of the whole.
void remove_conclusions(const RunFolder& folder) {
  for (const char* name : {"summary.json", "curve.svg", "deformed.svg", "detail.svg", "eigenvalues.svg",
                           "modes.svg", "stiffness.txt", "stiffness.json"}) {
    std::error_code ignored;
    fs::remove(folder.file(name), ignored);
  }
}

}  // namespace

RunResult run_deck(const DeckFile& deck, const RunOptions& options) {
  Timings timings;
  require_address_space();
  InterruptGuard guard(OnInterrupt::end);
  timings.end_start_up();
  Simulation simulation(deck.deck, timings);
  simulation.prepare();
  guard.set_flag_first();
  const RunFolder folder = new_folder(deck, options);
  const std::string effective = effective_deck(deck);
  write_decks(folder, deck, effective);
  write_model_picture(folder, simulation);
  simulation.stepper().log_to(folder.file("nox.log"));
  const std::string obstacle = simulation.apply_dead_loads();
  simulation.walker().effort().count_steps_anew();
  simulation.begin_path();
  RunRecorder recorder(folder, simulation, deck, effective, timings);
  Ending ending{Ending::Kind::stopped_early, obstacle};
  if (obstacle.empty()) ending = follow(simulation, recorder, options.quiet);
  follow_primary(deck, folder, recorder.memory());
  if (deck.deck.moves() && ending.kind != Ending::Kind::interrupted)
    if (const Ending moved = move_on(folder, simulation, recorder, {.quiet = options.quiet});
        !is_reached(moved))
      ending = moved;
  offer_motion(simulation, recorder);
  return conclude(folder, recorder, ending);
}

RunResult resume_run(const fs::path& existing, const std::vector<std::string>& overrides,
                     const RunOptions& options) {
  Timings timings;
  require_address_space();
  InterruptGuard guard(OnInterrupt::end);
  const RunFolder source = RunFolder::open(existing);
  require_restart(source);
  const RestartData data = read_restart(source.file("restart.h5"));
  const DeckFile deck = deck_of(data, existing, overrides);
  timings.end_start_up();
  Simulation simulation(deck.deck, timings);
  simulation.prepare();
  guard.set_flag_first();
  const RunMemory memory = restore(data, existing, simulation);
  const bool in_place = options.folder.empty();
  const RunFolder folder = in_place ? source : new_folder(deck, options);
  if (!in_place) copy_run(existing, folder);
  remove_conclusions(folder);
  const std::string effective = effective_deck(deck);
  write_decks(folder, deck, effective);
  simulation.stepper().log_to(folder.file("nox.log"));
  RunRecorder recorder(folder, simulation, deck, effective, timings, memory);
  Ending ending = follow(simulation, recorder, options.quiet);
  follow_primary(deck, folder, recorder.memory());
  if (deck.deck.moves() && ending.kind != Ending::Kind::interrupted)
    if (const Ending moved = move_on(folder, simulation, recorder, {.quiet = options.quiet, .goes_on = true});
        !is_reached(moved))
      ending = moved;
  offer_motion(simulation, recorder);
  return conclude(folder, recorder, ending);
}

std::string last_line(const RunResult& result) {
  const auto& summary = result.summary;
  const std::string bias =
      summary.contains("mesh_bias")
          ? fmt::format(" ({:+.1f} % of the reference)", 100 * summary["mesh_bias"].get<double>())
          : "";
  const std::string moved =
      summary.contains("motion") ? "; " + summary["motion"]["reason"].get<std::string>() : "";
  const std::size_t notices = summary["notices"].size();
  return fmt::format(
      "{}: {}{} — peak {:.6g} {}{} at step {}, {} steps{}, {:.2f} s{}", result.folder.string(),
      status_of(result.ending), result.ending.reason.empty() ? "" : " (" + result.ending.reason + ")",
      summary["peak"]["load"].get<double>(), result.measures.load_unit(), bias,
      summary["peak"]["step"].get<int>(), summary["steps"].get<int>(), moved,
      summary["timings"]["total"].get<double>(),
      notices == 0 ? "" : fmt::format("; {} notice{}: see summary.json", notices, notices == 1 ? "" : "s"));
}

}  // namespace dda
