#include "studies/dda/run/stepped_run.hpp"

#include <fmt/format.h>

#include "studies/dda/figures/model_picture.hpp"
#include "studies/dda/run/conclusion.hpp"
#include "studies/dda/run/new_run.hpp"
#include "studies/dda/run/next_point.hpp"

namespace dda {
namespace {

DeckFile with_path(DeckFile deck, Timings& timings) {
  timings.end_start_up();
  if (!deck.deck.has_path())
    throw InputError(Position{deck.path.string()},
                     "has no `stages`: there is no path to follow, only a motion, which `dda run` computes");
  return deck;
}

}  // namespace

SteppedRun::SteppedRun(DeckFile deck)
    : deck_(with_path(std::move(deck), timings_)), simulation_(deck_.deck, timings_) {
  simulation_.prepare();
}

void SteppedRun::carry_dead_loads() {
  const std::string obstacle = simulation_.apply_dead_loads();
  simulation_.walker().effort().count_steps_anew();
  simulation_.begin_path();
  if (!obstacle.empty()) ending_ = {Ending::Kind::stopped_early, obstacle, Stop::dead_load};
}

void SteppedRun::begin() { carry_dead_loads(); }

void SteppedRun::begin(const RunOptions& options) {
  options_ = options;
  folder_ = std::make_unique<const RunFolder>(new_folder(deck_, options));
  const std::string effective = effective_deck(deck_);
  write_decks(*folder_, deck_, effective);
  write_model_picture(*folder_, simulation_);
  simulation_.stepper().log_to(folder_->file("nox.log"));
  carry_dead_loads();
  recorder_ = std::make_unique<RunRecorder>(*folder_, simulation_, deck_, effective, timings_);
}

std::optional<Point> SteppedRun::next() {
  if (has_ended()) return {};
  return next_point(simulation_, recorder_.get(), ending_);
}

void SteppedRun::end(Ending ending) {
  if (!has_ended()) ending_ = std::move(ending);
}

void SteppedRun::switch_control(ControlChoice control) {
  std::swap(deck_.deck.path.control, control);
  try {
    simulation_.switch_control();
  } catch (...) {
    std::swap(deck_.deck.path.control, control);
    throw;
  }
  if (!is_recorded()) return;
  const std::string effective = effective_deck(deck_);
  write_decks(*folder_, deck_, effective);
  recorder_->go_on_with(effective);
}

void SteppedRun::go_on_with(StageParameters stage) {
  if (is_recorded())
    throw InputError(stage.where,
                     "a run in a folder has the loads of its deck; follow this one without a folder");
  if (has_ended()) throw InputError(stage.where, "the path has ended: " + ending_.reason);
  Deck& deck = deck_.deck;
  const auto leg = static_cast<std::size_t>(simulation_.path().memory().leg);
  if (leg + 1 < deck.legs().size())
    throw InputError(stage.where,
                     fmt::format("stage '{}' of the deck is yet to come", deck.legs()[leg + 1].name));
  const std::vector<StageParameters> before = deck.stages;
  deck.stages.back().until = {{"load_factor", simulation_.walker().state().load_factor}};
  deck.stages.push_back(std::move(stage));
  try {
    simulation_.go_on_with_last_stage("as told");
  } catch (const InputError&) {
    deck.stages = before;
    throw;
  }
}

RunResult SteppedRun::conclude() {
  RunResult out =
      conclude_run({deck_, *folder_, simulation_, *recorder_}, ending_, {.quiet = options_.quiet});
  recorder_.reset();  // whoever goes on with the run may have its folder from here
  folder_.reset();
  return out;
}

}  // namespace dda
