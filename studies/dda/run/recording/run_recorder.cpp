#include "studies/dda/run/recording/run_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "framework/files/whole_file.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/figures/paraview_state.hpp"
#include "studies/dda/figures/pictures.hpp"
#include "studies/dda/figures/stability_pictures.hpp"
#include "studies/dda/record/stability_record.hpp"
#include "studies/dda/record/warnings/closed_slits.hpp"
#include "studies/dda/record/warnings/coarse_zones.hpp"
#include "studies/dda/record/warnings/cracks_left_out.hpp"
#include "studies/dda/record/warnings/large_movements.hpp"
#include "studies/dda/record/warnings/turning_contacts.hpp"
#include "studies/dda/record/warnings/unlikely_numbers.hpp"
#include "studies/dda/run/recording/ended_path.hpp"
#include "studies/dda/run/recording/profile.hpp"
#include "studies/dda/run/recording/restart.hpp"
#include "studies/dda/run/recording/summary.hpp"

namespace dda {
namespace fs = std::filesystem;
namespace {

/// What a run may lose when it is killed or the machine goes down; a shorter run is sooner repeated [s].
constexpr double bearable_loss = 1.0;

/// Of the run that has never switched.
nlohmann::ordered_json primary_summary(const fs::path& file) {
  const auto other = nlohmann::ordered_json::parse(read_whole(file));
  return {{"folder", "primary"},
          {"status", other["status"]},
          {"peak", other["peak"]},
          {"dissipated_energy", other["dissipated_energy"]}};
}

}  // namespace

RunRecorder::RunRecorder(const RunFolder& folder, Simulation& simulation, const DeckFile& deck,
                         std::string effective, Timings& timings, std::optional<RunMemory> memory)
    : folder_(folder),
      simulation_(simulation),
      deck_(deck),
      effective_(std::move(effective)),
      timings_(timings),
      memory_(memory.value_or(RunMemory{})),
      interfaces_(simulation.equilibrium(), simulation.deck().units, memory_),
      indicator_(simulation, memory_.indicator),
      measures_(measures_here()),
      columns_(columns_of_rows()),
      fields_(simulation.body(), simulation.deck(), simulation.equilibrium(), simulation.deck().units),
      events_(measures_, simulation.walker(), memory_.last_step, memory_.events),
      log_(folder.file("log.jsonl"), memory ? FileWriter::Mode::append : FileWriter::Mode::create),
      curve_(open_curve(!memory)),
      results_(memory ? ResultsWriter::resume(folder.path(), memory->last_step)
                      : ResultsWriter(folder.path(), mesh(), texts())) {
  simulation.path().report_to([this](const std::string& event, const std::string& text) {
    log_.info(event, {{"step", memory_.last_step + 1}, {"text", text}});
  });
  simulation.when_grown([this] { store_peak(); }, [this](const Growth& growth) { follow(growth); });
  simulation.when_held([this](const StageEnd& end) { end_stage(end); }, [this] { begin_stage(); });
  events_.number_stages(stage_number());
  if (memory) {
    const std::vector<int> steps = results_.steps();
    last_stored_ = steps.empty() ? -1 : steps.back();
    last_ = measures_.measure(simulation.walker(), memory_.last_step, "resumed", 0);
    renew_stages();
    events_.remember_sizes(read_csv(folder.file("curve.csv")));
    log_.info("resumed", {{"step", memory_.last_step}});
  } else {
    start();
  }
  trace_.push_back(trace_point(simulation.walker(), measures_));
}

void RunRecorder::start() {
  log_.info(
      "started",
      {{"version", provenance().version}, {"deck", deck_.path.string()}, {"overrides", deck_.overrides}});
  for (const std::string& notice : simulation_.notices()) log_.warning("notice", {{"text", notice}});
  memory_.start = memory_.peak = last_ = measures_.measure(simulation_.walker(), 0, "start", 0);
  Point point;
  simulation_.path().judge(point);
  append_row(last_, point);
  store_here();
  if (simulation_.deck().record.stiffness) memory_.stiffness = stiffness_record(simulation_);
}

/// At the start, which a continued run remembers, and at the end.
void RunRecorder::write_stiffness() const {
  const StiffnessRecord end = stiffness_record(simulation_);
  const auto& [numbers, text] = memory_.stiffness;
  write_whole(folder_.file("stiffness.txt"), "Start\n" + text + "\nEnd\n" + end.text, Flush::to_system);
  const nlohmann::ordered_json both{{"start", numbers}, {"end", end.numbers}};
  write_whole(folder_.file("stiffness.json"), both.dump() + "\n", Flush::to_system);
}

void RunRecorder::append_row(const Measurement& now, const Point& point) {
  const RecordedStep at{point, now, simulation_.system().history(), events_here_};
  interfaces_.look(at);
  indicator_.look(at);
  memory_.indicator = indicator_.memory();
  std::vector<TableCell> cells;
  for (const RecordedColumn& column : columns_) cells.push_back(column.cell(at));
  curve_.append(cells);
}

StoredState RunRecorder::here() const {
  return {memory_.last_step, simulation_.walker().state(), simulation_.system().history(),
          indicator_.shapes()};
}

/// Modes that were computed because of an event are kept, those of every step with the fields only.
bool RunRecorder::is_due(const Point& point) const {
  const RecordParameters& record = simulation_.deck().record;
  const bool of_event = std::ranges::any_of(record.eigenvalues.at,
                                            [&](EventKind event) { return events_here_.contains(event); });
  return !point.landed.empty() || (record.eigenvalues.count > 0 && of_event) ||
         (record.fields_every > 0 && point.step % record.fields_every == 0);
}

void RunRecorder::record(const Point& point) {
  const auto scope = timings_.measure("output");
  const Measurement now =
      measures_.measure(simulation_.walker(), point.step, to_string(point.kind), point.newton_iterations);
  memory_.last_step = point.step;
  last_ = now;
  events_here_ =
      events_.add(point, simulation_.walker(), simulation_.path().ending().kind != Ending::Kind::running);
  memory_.events = events_.list();
  append_row(now, point);
  if (simulation_.cracks()) note_growth(*simulation_.cracks(), now, memory_.grown);
  keep_peak(point, now);
  log_step(point, now);
  look_for_crawling();
  trace_.push_back(trace_point(simulation_.walker(), measures_));
  if (is_due(point)) store_here();
  if (timings_.total() - restart_written_ >= bearable_loss) write_restart_file();
}

Flush RunRecorder::durability() const {
  return timings_.total() < bearable_loss ? Flush::to_system : Flush::to_disk;
}

/// Warns of a run that comes hardly nearer to its goal.
void RunRecorder::look_for_crawling() {
  constexpr int often = 100;
  constexpr double hardly = 0.01;
  if (last_.step % often != 0) return;
  const double goal = progress().goal;
  if (last_.step > often && goal - goal_before_ < hardly) {
    warning_ = fmt::format(
        "crawling: the last {} steps up to step {} brought the goal {:.1f} % nearer, {:.0f} % of the way are "
        "done; `path.stop.steps` ({}) ends it, a larger `path.step.accuracy` takes larger steps",
        often, last_.step, 100 * std::max(0.0, goal - goal_before_), 100 * goal,
        simulation_.path().most_steps());
    log_.warning("crawling", {{"step", last_.step}, {"text", warning_}});
  }
  goal_before_ = goal;
}

/// The state of the highest load is held back until the load falls, so that only the peak itself is stored; or until a
/// crack grows, whose new cuts would not be in equilibrium in it.
void RunRecorder::keep_peak(const Point& point, const Measurement& now) {
  const auto held = static_cast<int>(memory_.stages.size());
  if (std::exchange(memory_.peak_stage, held) != held) memory_.peak = now;  // its first row
  if (point.is_highest) {
    memory_.peak = now;
    memory_.peak_state = here();
    memory_.is_peak_stored = false;
  } else {
    store_peak();
  }
}

void RunRecorder::store_peak() {
  if (!memory_.peak_state || memory_.is_peak_stored) return;
  store(*memory_.peak_state, memory_.peak);
  memory_.is_peak_stored = true;
}

/// Figures draw the peak in the structure of the end, and modes are looked for in those before.
void RunRecorder::follow(const Growth& growth) {
  measures_ = measures_here();
  indicator_.follow(growth);
  memory_.indicator = indicator_.memory();
  if (!memory_.peak_state) return;
  StoredState& peak = *memory_.peak_state;
  peak.state.d = growth.unknowns(peak.state.d.all());
  peak.history = growth.of_points(peak.history);
  for (std::vector<double>& mode : peak.modes) mode = indicator_.followed(mode, growth);
  if (!peak.state.multipliers.empty()) peak.state.multipliers = growth.of_points(peak.state.multipliers);
}

void RunRecorder::store(const StoredState& at, const Measurement& measured) {
  if (at.step <= last_stored_) return;
  const auto scope = timings_.measure("fields");
  Snapshot snapshot = fields_.snapshot(at);
  snapshot.numbers.merge(measures_.numbers(measured));
  if (stage_number() > 0) snapshot.numbers[column::stage] = stage_number();
  results_.store(snapshot);
  last_stored_ = at.step;
}

void RunRecorder::store_here() { store(here(), last_); }

void RunRecorder::write_restart_file() {
  const auto scope = timings_.measure("restart file");
  RestartData data = restart_data(simulation_, memory_, deck_, effective_);
  put_ending(data, memory_.ended);
  write_restart(folder_.file("restart.h5"), data, durability());
  restart_written_ = timings_.total();
}

void RunRecorder::log_step(const Point& point, const Measurement& now) {
  Log::Fields fields{{"step", point.step},
                     {"control", to_string(point.kind)},
                     {"load_factor", now.load_factor},
                     {"load", now.load},
                     {"newton_iterations", point.newton_iterations},
                     {"residual", point.residual},
                     {"tolerance", simulation_.deck().path.newton.tolerance}};
  if (simulation_.system().iterates_multipliers()) {
    fields["multiplier_iterations"] = point.multiplier_iterations;
    fields["gap"] = point.gap;
    memory_.largest_gap = std::max(memory_.largest_gap, point.gap);
  }
  if (!point.landed.empty()) fields["landed"] = point.landed;
  if (point.jump_energy != 0) fields["jump_energy"] = point.jump_energy;
  log_.info("step", fields);
}

void RunRecorder::look_back() {
  notices_ = simulation_.notices();
  const std::size_t known = notices_.size();
  const bool has_fallen = std::abs(last_.load) < 0.9 * std::abs(memory_.peak.load);
  torn_ = torn_pieces(simulation_, simulation_.system().history(), has_fallen);
  if (memory_.peak_state)
    for (TornPiece& piece : torn_pieces(simulation_, memory_.peak_state->history, false))
      if (std::ranges::find(torn_, piece.blocks, &TornPiece::blocks) == torn_.end())
        torn_.push_back(std::move(piece));
  for (const TornPiece& piece : torn_) notices_.push_back(text(simulation_, piece));
  for (const CoarseZone& zone : cracked_coarse_zones(simulation_))
    notices_.push_back(text(simulation_, zone));
  std::ranges::move(unlikely_numbers(simulation_), std::back_inserter(notices_));
  const State* peak = memory_.peak_state ? &memory_.peak_state->state : nullptr;
  for (std::string note : {note_on_turning_contacts(simulation_), note_on_large_movements(simulation_),
                           note_on_closed_slits(simulation_, peak), note_on_shallow_corners(simulation_),
                           note_on_cracks_left_out(simulation_, peak)})
    if (!note.empty()) notices_.push_back(std::move(note));
  notices_.insert(notices_.end(), offered_.begin(), offered_.end());
  for (std::size_t i = known; i < notices_.size(); ++i) log_.warning("notice", {{"text", notices_[i]}});
}

nlohmann::ordered_json RunRecorder::finish(const Ending& ending) {
  look_back();
  {
    const auto scope = timings_.measure("output");
    store_here();
    if (memory_.peak_state && memory_.peak_state->step == last_stored_) memory_.is_peak_stored = true;
    write_restart_file();
    const auto inner = timings_.measure("figures");
    write_pictures(folder_, fields_, measures_, {memory_, here(), simulation_.deck().record, torn_});
    write_paraview_state(folder_, simulation_, magnification(fields_, here().state));
    if (deck_.deck.record.eigenvalues.count > 0) write_stability_pictures(folder_, fields_, measures_);
    if (deck_.deck.record.stiffness) write_stiffness();
  }
  log_.info("ended", {{"status", status_of(ending)}, {"reason", ending.reason}});
  const CsvTable curve = read_csv(folder_.file("curve.csv"));
  memory_.events = events_with_peaks(memory_, measures_, curve);
  nlohmann::ordered_json out = summarise(simulation_, memory_, measures_, ending);
  out["newton_iterations"] = iterations_of(curve);
  out["stability"] = stability_counts(curve);
  out["interfaces"] = interfaces_.summary(fields_, here());
  if (simulation_.cracks())
    out["cracks"] = cracks_summary(*simulation_.cracks(), memory_.grown, fields_, here());
  if (!motion_.is_null()) out["motion"] = motion_;
  out["notices"] = notices_;
  if (!torn_.empty()) out["torn_out"] = to_json(simulation_, torn_);
  if (deck_.deck.record.condition) {
    const auto scope = timings_.measure("stiffness quality");
    out["stiffness"] = stiffness_quality(simulation_);
  }
  if (const auto primary = folder_.file("primary") / "summary.json"; fs::exists(primary))
    out["without_switching"] = primary_summary(primary);
  out["peak_memory_mib"] = peak_memory_mib();
  if (ranks_of_run()) out["ranks"] = to_json(*ranks_of_run());
  out["timings"] = to_json(timings_);
  out["profile"] = profile_of(timings_, simulation_);
  write_whole(folder_.file("summary.json"), out.dump(2) + "\n", durability());
  return out;
}

ProgressPoint RunRecorder::progress() const {
  const Walker& walker = simulation_.walker();
  const StopRules& stop = simulation_.deck().path.stop;
  ProgressPoint out{.step = last_.step,
                    .load_factor = last_.load_factor,
                    .control = last_.control,
                    .gauges = {{"load", last_.load}},
                    .iterations = last_.newton_iterations,
                    .step_size = simulation_.path().memory().step};
  for (std::size_t i = 0; i < measures_.num_gauges(); ++i)
    out.gauges.emplace_back(measures_.names()[i].name, last_.values[i]);
  double goal = stop.after_steps > 0 ? static_cast<double>(last_.step) / stop.after_steps : 0;
  const double peak = std::abs(memory_.peak.load), now = std::abs(last_.load);
  if (peak > 0 && walker.here().dissipated > 0)
    goal = std::max(goal, (peak - now) / (peak * (1 - stop.load_below)));
  goal = std::max(goal, simulation_.path().share_of_goals());
  out.goal = std::clamp(goal, 0.0, 1.0);
  return out;
}

}  // namespace dda
