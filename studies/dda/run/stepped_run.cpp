#include "studies/dda/run/stepped_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

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

/// Where the path stands, as a goal that it has not passed before: the load factor while the load is higher than ever in its
/// stage, else a gauge that is farther from where it was when the stage began.
std::map<std::string, double> goal_here(const Simulation& simulation) {
  const Walker& walker = simulation.walker();
  const auto& travels = simulation.path().memory().travels;
  const auto is_farthest = [&](const std::string& name, double now) {
    const auto travel = travels.find(name);
    return travel != travels.end() && travel->second.farthest == now && travel->second.from != now;
  };
  const auto gauges = simulation.gauges().gauges;
  const auto found = std::ranges::find_if(gauges, [&](const NamedGauge& gauge) {
    return is_farthest(gauge.name, walker.value(gauge.functional));
  });
  if (found == gauges.end() || is_farthest("load", walker.value(simulation.loading().load)))
    return {{"load_factor", walker.state().load_factor}};
  return {{found->name, walker.value(found->functional)}};
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
  if (has_ended()) throw InputError(stage.where, "the path has ended: " + ending_.reason);
  Deck& deck = deck_.deck;
  const auto leg = static_cast<std::size_t>(simulation_.path().memory().leg);
  if (leg + 1 < deck.legs().size())
    throw InputError(stage.where,
                     fmt::format("stage '{}' of the deck is yet to come", deck.legs()[leg + 1].name));
  if (is_recorded() && simulation_.walker().effort().accepted == 0)
    throw InputError(
        stage.where,
        "no step has been taken yet: in a run that is recorded these loads are a stage of its deck");
  const std::vector<StageParameters> before = deck.stages;
  deck.stages.back().until = goal_here(simulation_);
  deck.stages.push_back(std::move(stage));
  try {
    simulation_.go_on_with_last_stage("as told");
  } catch (const InputError&) {
    deck.stages = before;
    throw;
  }
  if (!is_recorded()) return;
  const std::string effective = effective_deck(deck_);
  recorder_->go_on_with_stage(effective);
  write_decks(*folder_, deck_, effective);
}

RunResult SteppedRun::conclude() {
  RunResult out =
      conclude_run({deck_, *folder_, simulation_, *recorder_}, ending_, {.quiet = options_.quiet});
  recorder_.reset();  // whoever goes on with the run may have its folder from here
  folder_.reset();
  return out;
}

}  // namespace dda
