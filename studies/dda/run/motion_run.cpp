#include "studies/dda/run/motion_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "continuation/motion/handover.hpp"
#include "continuation/motion/motion.hpp"
#include "framework/figure/drawing.hpp"
#include "framework/figure/plot.hpp"
#include "framework/files/curve_table.hpp"
#include "framework/files/run/results_writer.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/interrupt.hpp"
#include "framework/messages/progress.hpp"
#include "framework/messages/provenance.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

constexpr const char *kinetic = "kinetic_energy", *stored = "stored_energy", *work = "external_work",
                     *friction = "friction", *fracture = "fracture", *numerical = "impact_and_damping",
                     *error = "energy_error";

std::vector<Column> columns(const Units& units) {
  const std::string energy = label(dimension::energy, units);
  return {{"step", ""},     {"time", "s"},       {"time_step", "s"}, {"iterations", ""},
          {"meetings", ""}, {"live_joints", ""}, {work, energy},     {kinetic, energy},
          {stored, energy}, {friction, energy},  {fracture, energy}, {numerical, energy},
          {error, energy}};
}

std::int64_t live_joints(const Motion& motion) {
  return std::ranges::count_if(motion.bonds(), [](const Bond& bond) { return !bond.is_spent(); });
}

/// Writes what happens while a structure moves.
class MotionRecorder {
 public:
  MotionRecorder(const RunFolder& folder, const Simulation& simulation, const Motion& motion)
      : folder_(made(folder.file("motion"))),
        simulation_(simulation),
        motion_(motion),
        table_(folder_ / "motion.csv", columns(simulation.deck().units)),
        results_(folder_, mesh(), {{"version", provenance().version}}) {
    store();
  }

  void record() {
    ++steps_;
    const MotionLedger& ledger = motion_.ledger();
    const std::vector<TableCell> row{std::int64_t{steps_},
                                     motion_.time(),
                                     motion_.step().before,
                                     std::int64_t{motion_.iterations()},
                                     static_cast<std::int64_t>(motion_.num_meetings()),
                                     live_joints(motion_),
                                     ledger.external,
                                     ledger.kinetic,
                                     ledger.stored.sum(),
                                     ledger.friction,
                                     ledger.fracture,
                                     ledger.numerical,
                                     ledger.error};
    table_.append(row);
    const MotionParameters& parameters = *simulation_.deck().motion;
    const double every = parameters.frame_every > 0 ? parameters.frame_every : parameters.time / 100;
    if (motion_.time() >= (frames_ + 1) * every) {
      frames_ = static_cast<int>(motion_.time() / every);
      store();
    }
  }

  void finish() {
    if (stored_ != steps_) store();
    write_whole(folder_ / "end.svg", to_svg(picture()), Flush::to_system);
    if (steps_ > 0) write_whole(folder_ / "energies.svg", to_svg(energies()), Flush::to_system);
  }

  int steps() const { return steps_; }

 private:
  static fs::path made(const fs::path& folder) {
    std::error_code failed;
    fs::remove_all(folder / fields_folder, failed);
    fs::create_directories(folder, failed);
    if (failed) throw OutputError(fmt::format("cannot make '{}': {}", folder.string(), failed.message()));
    return folder;
  }

  ResultsMesh mesh() const {
    ResultsMesh out{
        .blocks = {}, .block_region = {}, .segments = {}, .length_unit = simulation_.deck().units.length};
    for (const Block& block : simulation_.assembly().blocks) {
      out.blocks.push_back(block.outline.vertices);
      out.block_region.push_back(block.region);
    }
    return out;
  }

  std::vector<Vec2> outline(std::size_t b) const {
    std::vector<Vec2> out;
    const Block& block = simulation_.assembly().blocks[b];
    for (const Vec2& x : block.outline.vertices)
      out.push_back(place_of(motion_.poses()[b], x - block.moments.centroid));
    return out;
  }

  void store() {
    const std::string length = simulation_.deck().units.length;
    StoredField moved{"displacement", length, FieldPlace::block_vertex, 2, {}, "x y z"};
    StoredField velocity{"velocity", length + "/s", FieldPlace::block, 2, {}, "x y z"};
    StoredField angle{"rotation", "", FieldPlace::block, 1, {}, ""};
    const Poses velocities = motion_.velocities();
    for (std::size_t b = 0; b < velocities.size(); ++b) {
      const std::vector<Vec2>& before = simulation_.assembly().blocks[b].outline.vertices;
      const std::vector<Vec2> now = outline(b);
      for (std::size_t v = 0; v < now.size(); ++v)
        for (const double component : Vec2(now[v] - before[v])) moved.values.push_back(component);
      for (const double component : centre_of(velocities[b])) velocity.values.push_back(component);
      angle.values.push_back(polar_of(gradient_of(motion_.poses()[b])).angle);
    }
    results_.store({.step = steps_,
                    .time = motion_.time(),
                    .numbers = {{"time_of_motion", motion_.time()}},
                    .fields = {std::move(moved), std::move(velocity), std::move(angle)}});
    stored_ = steps_;
  }

  svg::Drawing picture() const {
    svg::Drawing out{.title = simulation_.deck().title,
                     .caption = fmt::format("after {:.4g} s of motion, at true scale", motion_.time())};
    for (std::size_t b = 0; b < motion_.poses().size(); ++b) out.polygons.push_back({.outline = outline(b)});
    return out;
  }

  svg::Figure energies() const {
    const CsvTable table = read_csv(folder_ / "motion.csv");
    svg::Panel panel{
        .x_label = "time [s]",
        .y_label = fmt::format("energy [{}]", label(dimension::energy, simulation_.deck().units))};
    for (const char* name : {work, kinetic, stored, friction, fracture, numerical}) {
      std::string text = name;
      std::ranges::replace(text, '_', ' ');
      panel.series.push_back({.name = text, .x = table.numbers("time"), .y = table.numbers(name)});
    }
    svg::Figure out;
    out.panels.push_back(std::move(panel));
    return out;
  }

  const fs::path folder_;
  const Simulation& simulation_;
  const Motion& motion_;
  CurveTable table_;
  ResultsWriter results_;
  int steps_ = 0, frames_ = 0, stored_ = -1;
};

nlohmann::ordered_json summary_of(const Motion& motion, const Ending& ending, int steps, bool is_pushed) {
  const MotionLedger& ledger = motion.ledger();
  return {{"folder", "motion"},
          {"is_at_rest", motion.ending() == Motion::Ending::at_rest},
          {"reason", ending.reason},
          {"time", motion.time()},
          {"steps", steps},
          {"rejected_steps", motion.rejected()},
          {"iterations", motion.iterations()},
          {"is_pushed", is_pushed},
          {"live_joints", live_joints(motion)},
          {work, ledger.external},
          {kinetic, ledger.kinetic},
          {stored, ledger.stored.sum()},
          {friction, ledger.friction},
          {fracture, ledger.fracture},
          {numerical, ledger.numerical},
          {error, ledger.error}};
}

Ending ending_of(const Motion& motion, bool is_interrupted) {
  if (is_interrupted)
    return {Ending::Kind::interrupted, "interrupted in the motion; `dda resume` begins it again"};
  const bool has_failed = motion.ending() == Motion::Ending::failed;
  return {has_failed ? Ending::Kind::stopped_early : Ending::Kind::goal_reached,
          "motion: " + motion.reason()};
}

}  // namespace

MotionRecord run_motion(const RunFolder& folder, Simulation& simulation, bool quiet) {
  const auto scope = simulation.system().timings().measure("motion");
  const MotionParameters& parameters = *simulation.deck().motion;
  const Walker& walker = simulation.walker();
  const bool has_fallen = walker.leaving().load_factor * walker.state().load_factor < 0;
  Handover start =
      hand_over(simulation.body(), {simulation.system(), walker.state(), has_fallen}, parameters);
  const Poses at_rest(start.poses.size(), Pose::Zero());
  Motion motion(
      start.scene, std::move(start.bonds), std::move(start.poses), at_rest,
      {.time = parameters.time, .stops_at_rest = parameters.stops_at_rest, .step = parameters.step});
  MotionRecorder recorder(folder, simulation, motion);
  Progress progress = Progress::for_stream(stderr, quiet);
  while (!interrupted() && motion.advance()) {
    recorder.record();
    progress.show({.step = recorder.steps(),
                   .load_factor = walker.state().load_factor,
                   .control = "motion",
                   .gauges = {{"time", motion.time()}, {kinetic, motion.ledger().kinetic}},
                   .iterations = motion.iterations(),
                   .step_size = motion.step().before,
                   .goal = motion.time() / parameters.time});
  }
  progress.finish();
  recorder.finish();
  const bool is_interrupted = motion.ending() == Motion::Ending::none;
  const Ending ending = ending_of(motion, is_interrupted);
  return {ending, summary_of(motion, ending, recorder.steps(), start.is_pushed)};
}

}  // namespace dda
