#include "studies/dda/run/run.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "framework/files/run/results.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/interrupt.hpp"
#include "studies/dda/run/conclusion.hpp"
#include "studies/dda/run/new_run.hpp"
#include "studies/dda/run/next_point.hpp"
#include "studies/dda/run/recording/ended_path.hpp"
#include "studies/dda/run/recording/restart.hpp"
#include "studies/dda/run/recording/summary.hpp"
#include "studies/dda/run/stepped_run.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

void show(RunRecorder& recorder, Progress& progress) {
  if (const std::string warning = recorder.take_warning(); !warning.empty()) progress.note(warning);
  progress.show(recorder.progress());
}

/// The files that a continued run goes on with.
void copy_run(const fs::path& from, const RunFolder& to) {
  const auto copy = [&](const char* name) {
    std::error_code error;
    fs::copy(from / name, to.file(name), fs::copy_options::overwrite_existing | fs::copy_options::recursive,
             error);
    if (error)
      throw OutputError(fmt::format("cannot copy '{}': {}", (from / name).string(), error.message()));
  };
  for (const char* name :
       {"curve.csv", "curve.units.json", "log.jsonl", fields_folder, "run.xdmf", "restart.h5"})
    copy(name);
  if (fs::exists(from / "model.svg")) copy("model.svg");  // large structures have none
  copy_motion(from, to);
}

/// A run that was killed in its first second has left a deck and no more, or not even that.
void require_restart(const RunFolder& folder) {
  std::error_code error;
  if (fs::exists(folder.file("restart.h5"), error)) return;
  const bool has_begun = fs::exists(folder.file("effective_deck.yaml"), error);
  throw InputError(Position{folder.path().string()},
                   fmt::format("{}; `dda run DECK --folder {} --overwrite` starts it{}",
                               has_begun ? "the run ended before its first restart file"
                                         : "there is no run here, or it ended before it had begun",
                               folder.path().string(), has_begun ? " again" : ""));
}

/// A number of steps that has been passed is no goal.
void require_steps_ahead(const Simulation& simulation, const fs::path& folder) {
  const int wanted = simulation.deck().path.stop.after_steps, made = simulation.walker().effort().accepted;
  if (wanted > 0 && wanted < made)
    throw InputError(
        Position{folder.string()},
        fmt::format("path.stop.after_steps: {} steps are wanted, and the run has made {}", wanted, made));
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
  InterruptGuard guard(OnInterrupt::end);
  SteppedRun run(deck);
  guard.set_flag_first();
  run.begin(options);
  run.interrupt_when(interrupted);
  Progress progress = Progress::for_stream(stderr, options.quiet);
  while (run.next()) show(run.recorder(), progress);
  progress.finish();
  return run.conclude();
}

RunResult resume_run(const fs::path& existing, const std::vector<std::string>& overrides,
                     const RunOptions& options) {
  Timings timings;
  InterruptGuard guard(OnInterrupt::end);
  const RunFolder source = RunFolder::open(existing);
  require_restart(source);
  const RestartData data = read_restart(source.file("restart.h5"));
  const DeckFile deck = deck_of(data, existing, overrides);
  timings.end_start_up();
  Simulation simulation(deck.deck, timings);
  simulation.prepare();
  guard.set_flag_first();
  RunMemory memory = restore(data, existing, simulation);
  memory.ended = take_ending(data, deck);
  require_steps_ahead(simulation, existing);
  const bool in_place = options.folder.empty();
  const RunFolder folder = in_place ? source : new_folder(deck, options);
  if (!in_place) copy_run(existing, folder);
  remove_conclusions(folder);
  const std::string effective = effective_deck(deck);
  write_decks(folder, deck, effective);
  simulation.stepper().log_to(folder.file("nox.log"));
  RunRecorder recorder(folder, simulation, deck, effective, timings, memory);
  simulation.path().interrupt_when(interrupted);
  Ending ending = memory.ended.value_or(Ending{});
  Progress progress = Progress::for_stream(stderr, options.quiet);
  while (!memory.ended && next_point(simulation, &recorder, ending)) show(recorder, progress);
  progress.finish();
  return conclude_run({deck, folder, simulation, recorder}, ending,
                      {.quiet = options.quiet, .goes_on = true});
}

std::string last_line(const RunResult& result) {
  const auto& summary = result.summary;
  const std::string bias =
      summary.contains("mesh_bias")
          ? fmt::format(" ({:+.1f} % of the reference)", 100 * summary["mesh_bias"].get<double>())
          : "";
  const std::string moved =
      summary.contains("motion") ? "; " + summary["motion"]["reason"].get<std::string>() : "";
  const std::string unit = result.measures.load_unit();
  const std::size_t notices = summary["notices"].size();
  return fmt::format(
      "{}: {}{} — peak {:.6g}{}{} at step {}, {} steps{}, {:.2f} s{}{}", result.folder.string(),
      status_of(result.ending), result.ending.reason.empty() ? "" : " (" + result.ending.reason + ")",
      summary["peak"]["load"].get<double>(), unit.empty() ? "" : " " + unit, bias,
      summary["peak"]["step"].get<int>(), summary["steps"].get<int>(), moved,
      summary["timings"]["total"].get<double>(),
      notices == 0 ? "" : fmt::format("; {} notice{}: see summary.json", notices, notices == 1 ? "" : "s"),
      what_now(result.ending));
}

}  // namespace dda
