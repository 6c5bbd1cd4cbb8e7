#include "studies/dda/run/motion_alone.hpp"

#include <fmt/format.h>

#include <functional>
#include <memory>

#include "framework/base/threads.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/interrupt.hpp"
#include "framework/messages/log.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/run/motion/motion_run.hpp"
#include "studies/dda/run/new_run.hpp"
#include "studies/dda/run/recording/summary.hpp"

namespace dda {
namespace {

constexpr auto effective = "effective_deck.yaml";

nlohmann::ordered_json summary_of(const Simulation& simulation, const MotionRecord& motion,
                                  const Timings& timings) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  const Units& units = simulation.deck().units;
  nlohmann::ordered_json out{{"title", simulation.deck().title},
                             {"status", status_of(motion.ending)},
                             {"reason", motion.ending.reason},
                             {"blocks", equilibrium.num_blocks()},
                             {"interface_points", equilibrium.num_points()},
                             {"motion", motion.summary},
                             {"notices", simulation.notices()},
                             {"units", {{"length", units.length}, {"force", units.force}}},
                             {"timings", to_json(timings)},
                             {"threads", num_threads()}};
  if (motion.ending.stop) out["stop"] = to_string(*motion.ending.stop);
  add_program(out);
  return out;
}

/// A structure that is let go without a path.
class Run {
 public:
  Run(const DeckFile& deck, const RunOptions& options) : deck_(deck), options_(options) {
    timings_.end_start_up();
    simulation_ = std::make_unique<const Simulation>(deck.deck, timings_);
    guard_.set_flag_first();
  }

  /// Into the folder that `made` makes once the deck is known to be right.
  MotionResult move(const std::function<RunFolder()>& made, bool goes_on) {
    const RunFolder folder = made();
    write_decks(folder, deck_, effective_deck(deck_));
    Log log = opened_log(folder, goes_on);
    const MotionRecord motion = moved(folder, goes_on);
    log.info("motion", motion.summary);
    log.info("ended", {{"status", status_of(motion.ending)}, {"reason", motion.ending.reason}});
    const nlohmann::ordered_json summary = summary_of(*simulation_, motion, timings_);
    write_whole(folder.file("summary.json"), summary.dump(2) + "\n", Flush::to_disk);
    return {folder.path(), motion.ending, summary};
  }

 private:
  Log opened_log(const RunFolder& folder, bool goes_on) const {
    const auto file = folder.file("log.jsonl");
    if (goes_on) {
      Log log(file, FileWriter::Mode::append);
      log.info("resumed");
      return log;
    }
    Log log(file);
    log.info(
        "started",
        {{"version", provenance().version}, {"deck", deck_.path.string()}, {"overrides", deck_.overrides}});
    for (const std::string& notice : simulation_->notices()) log.warning("notice", {{"text", notice}});
    return log;
  }

  MotionRecord moved(const RunFolder& folder, bool goes_on) {
    const auto scope = timings_.measure("motion");
    const Equilibrium& equilibrium = simulation_->equilibrium();
    const State undeformed{.d = Displacements(std::vector<double>(equilibrium.num_unknowns(), 0.0))};
    const std::vector<History> history(equilibrium.num_active());
    return run_motion(folder, *simulation_, {equilibrium, undeformed, history},
                      {.quiet = options_.quiet, .goes_on = goes_on});
  }

  const DeckFile& deck_;
  const RunOptions& options_;
  Timings timings_;
  InterruptGuard guard_{OnInterrupt::end};
  std::unique_ptr<const Simulation> simulation_;
};

}  // namespace

MotionResult run_motion_alone(const DeckFile& deck, const RunOptions& options) {
  return Run(deck, options).move([&] { return new_folder(deck, options); }, false);
}

bool is_motion_alone(const std::filesystem::path& folder) {
  const std::filesystem::path deck = folder / effective;
  return std::filesystem::exists(deck) && !std::filesystem::exists(folder / "curve.csv") &&
         !read_deck(deck, {}).deck.has_path();
}

MotionResult resume_motion_alone(const std::filesystem::path& existing,
                                 const std::vector<std::string>& overrides, const RunOptions& options) {
  DeckFile deck = read_deck(existing / effective, overrides);
  deck.text = read_whole(existing / "deck.yaml");
  const auto folder = [&] {
    const RunFolder source = RunFolder::open(existing);
    if (options.folder.empty()) return source;
    const RunFolder copy = new_folder(deck, options);
    copy_motion(existing, copy);
    std::error_code missing;  // a run of an earlier version has no log
    std::filesystem::copy_file(existing / "log.jsonl", copy.file("log.jsonl"), missing);
    return copy;
  };
  return Run(deck, options).move(folder, true);
}

std::string last_line(const MotionResult& result) {
  const std::size_t notices = result.summary["notices"].size();
  return fmt::format(
      "{}: {} ({}) — {} steps, {:.2f} s{}{}", result.folder.string(), status_of(result.ending),
      result.ending.reason, result.summary["motion"]["steps"].get<int>(),
      result.summary["timings"]["total"].get<double>(),
      notices == 0 ? "" : fmt::format("; {} notice{}: see summary.json", notices, notices == 1 ? "" : "s"),
      what_now(result.ending));
}

}  // namespace dda
