#include "studies/dda/run/motion/motion_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "continuation/handover/beginning.hpp"
#include "continuation/handover/regions.hpp"
#include "continuation/motion/motion.hpp"
#include "framework/figure/drawing.hpp"
#include "framework/figure/plot.hpp"
#include "framework/files/curve_table.hpp"
#include "framework/files/run/results_writer.hpp"
#include "framework/files/whole_file.hpp"
#include "framework/messages/interrupt.hpp"
#include "framework/messages/progress.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/case/model_tables.hpp"
#include "studies/dda/case/motion_columns.hpp"
#include "studies/dda/figures/material_colours.hpp"
#include "studies/dda/record/fields.hpp"
#include "studies/dda/run/motion/motion_restart.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;

using namespace motion_column;

std::int64_t live_joints(const Motion& motion) {
  return std::ranges::count_if(motion.bonds(), [](const Bond& bond) { return bond.holds(); });
}

/// What moves, and how it is called.
struct Moved {
  const Deck& deck;
  const Pieces& pieces;
  const Motion& motion;
  double load_factor;  ///< at which the path has ended
  double time;         ///< that it may take [T]

  const std::vector<Block>& blocks() const { return pieces.body().assembly.blocks; }
  const std::vector<std::string>& interfaces() const { return pieces.equilibrium().interfaces().names; }
  const std::vector<NamedGauge>& gauges() const { return pieces.equilibrium().stages().back().gauges; }
};

constexpr auto restart_name = "restart.h5";

/// All of a deck by which a motion goes, but for where it ends and what is kept of it.
std::string restart_deck(Deck deck) {
  deck.title.clear();
  deck.record = RecordParameters{};
  deck.motion->time = 1;
  deck.motion->stops_at_rest = false;
  deck.motion->frame_every = 0;
  return to_yaml(deck_schema().echo(deck));
}

/// Writes what happens while a structure moves.
class MotionRecorder {
 public:
  /// A recorder that goes on where an earlier one stood, or begins.
  static MotionRecorder make(const fs::path& folder, const Moved& moved,
                             const std::optional<MotionRestart>& before) {
    if (!before) {
      make_folder(folder);
      MotionRecorder out(folder, moved, CurveTable(folder / "motion.csv", columns(moved)),
                         ResultsWriter(folder, mesh(moved), {{"version", provenance().version}}));
      out.store();
      return out;
    }
    MotionRecorder out(
        folder, moved,
        CurveTable::resume(folder / "motion.csv", columns(moved), static_cast<std::size_t>(before->steps)),
        ResultsWriter::resume(folder, before->stored));
    out.at_ = *before;
    return out;
  }

  /// Whether a state has been stored as well.
  bool record() {
    ++at_.steps;
    const MotionLedger& ledger = motion_.ledger();
    std::vector<TableCell> row{std::int64_t{at_.steps},
                               motion_.time(),
                               motion_.step().before,
                               std::int64_t{motion_.iterations()},
                               static_cast<std::int64_t>(motion_.num_meetings()),
                               live_joints(motion_),
                               ledger.external,
                               ledger.kinetic,
                               ledger.stored.sum(),
                               ledger.stored.strain,
                               ledger.stored.contact + ledger.stored.friction,
                               ledger.stored.impacts,
                               ledger.friction,
                               ledger.fracture,
                               ledger.damping,
                               ledger.impact,
                               ledger.numerical,
                               ledger.error};
    for (std::size_t i = 0; i < moved_.interfaces().size(); ++i)
      row.emplace_back(i < ledger.fracture_of.size() ? ledger.fracture_of[i] : 0.0);
    for (const NamedGauge& gauge : moved_.gauges()) row.emplace_back(value(gauge.functional));
    table_.append(row);
    if (const double every = between_frames(); every > every_) thin_out(every);
    const bool is_due = motion_.time() >= (at_.frames + 1) * every_;
    if (is_due) {
      at_.frames = static_cast<int>(motion_.time() / every_);
      store();
    }
    const Clock::time_point now = Clock::now();
    if (now - written_ > between_restarts) write_restart_file();
    return is_due;
  }

  void finish() {
    write_restart_file();
    if (at_.stored != at_.steps) store();
    write_whole(folder_ / "end.svg", to_svg(picture()), Flush::to_system);
    if (at_.steps > 0) write_whole(folder_ / "energies.svg", to_svg(energies()), Flush::to_system);
  }

  int steps() const { return at_.steps; }

 private:
  /// Where the deck leaves it open so short that there are a hundred frames at least, however early all is at rest, and
  /// twice as long whenever there are twice as many: a hundred where it takes its whole time.
  double between_frames() const {
    constexpr double frames = 100, shortest = 1.0 / 256;
    if (const double wanted = moved_.deck.motion->frame_every; wanted > 0) return wanted;
    double out = shortest * moved_.time / frames;
    while (motion_.time() > (1 - 1e-9) * 2 * frames * out) out *= 2;
    return out;
  }

  /// Leaves the frames that would have been stored had they always been so far apart.
  void thin_out(double every) {
    every_ = every;
    at_.frames = 0;
    results_.remove([&](double time) {
      if (time == 0) return false;
      const bool is_needless = time < (at_.frames + 1) * every;
      if (!is_needless) at_.frames = static_cast<int>(time / every);
      return is_needless;
    });
  }

  static void make_folder(const fs::path& folder) {
    std::error_code failed;
    fs::remove_all(folder / fields_folder, failed);
    fs::remove(folder / restart_name, failed);
    fs::create_directories(folder, failed);
    if (failed) throw OutputError(fmt::format("cannot make '{}': {}", folder.string(), failed.message()));
  }

  static std::vector<Column> columns(const Moved& moved) {
    const Units& units = moved.deck.units;
    std::vector<Column> out = all(units, moved.interfaces());
    for (const NamedGauge& gauge : moved.gauges()) out.push_back({gauge.name, label(gauge.dimension, units)});
    return out;
  }

  /// A gauge of the path at finite rotations: the same row on how far its material points have moved.
  double value(const Functional& gauge) const {
    double out = gauge.per_load_factor * moved_.load_factor + gauge.constant;
    for (const auto& [block, row] : gauge.rows)
      out +=
          finite_row(row).dot(motion_.poses()[block.value()] -
                              pose_of(moved_.pieces.body().block(block).moments.centroid, Mat2::Identity()));
    return out;
  }

  static ResultsMesh mesh(const Moved& moved) {
    ResultsMesh out{.blocks = {},
                    .block_region = {},
                    .region_names = region_names(moved.pieces.body().assembly),
                    .segments = {},
                    .length_unit = moved.deck.units.length,
                    .model = {region_materials(moved.pieces.body().assembly)}};
    for (const Block& block : moved.blocks()) {
      out.blocks.push_back(block.outline.vertices);
      out.block_region.push_back(block.region);
    }
    return out;
  }

  std::vector<Vec2> outline(std::size_t b) const {
    std::vector<Vec2> out;
    const Block& block = moved_.blocks()[b];
    for (const Vec2& x : block.outline.vertices)
      out.push_back(place_of(motion_.poses()[b], x - block.moments.centroid));
    return out;
  }

  void store() {
    const std::string length = moved_.deck.units.length;
    StoredField moved{"displacement", length, FieldPlace::block_vertex, 2, {}, "x y z"};
    StoredField velocity{"velocity", length + "/s", FieldPlace::block, 2, {}, "x y z"};
    StoredField angle{"rotation", "", FieldPlace::block, 1, {}, ""};
    const Poses velocities = motion_.velocities();
    for (std::size_t b = 0; b < velocities.size(); ++b) {
      const std::vector<Vec2>& before = moved_.blocks()[b].outline.vertices;
      const std::vector<Vec2> now = outline(b);
      for (std::size_t v = 0; v < now.size(); ++v)
        for (const double component : Vec2(now[v] - before[v])) moved.values.push_back(component);
      for (const double component : centre_of(velocities[b])) velocity.values.push_back(component);
      angle.values.push_back(polar_of(gradient_of(motion_.poses()[b])).angle);
    }
    results_.store({.step = at_.steps,
                    .time = motion_.time(),
                    .numbers = numbers(),
                    .fields = {std::move(moved), std::move(velocity), std::move(angle)}});
    at_.stored = at_.steps;
  }

  /// What stored fields have beside them: gauges and energies.
  std::map<std::string, double> numbers() const {
    const MotionLedger& ledger = motion_.ledger();
    std::map<std::string, double> out{
        {"time_of_motion", motion_.time()}, {work, ledger.external},     {kinetic, ledger.kinetic},
        {stored, ledger.stored.sum()},      {friction, ledger.friction}, {fracture, ledger.fracture},
        {damping, ledger.damping},          {impact, ledger.impact},     {numerical, ledger.numerical}};
    for (const NamedGauge& gauge : moved_.gauges()) out.emplace(gauge.name, value(gauge.functional));
    return out;
  }

  svg::Drawing picture() const {
    svg::Drawing out{.title = moved_.deck.title,
                     .caption = fmt::format("after {:.4g} s of motion, at true scale", motion_.time())};
    const MaterialColours colours = material_colours(moved_.pieces.body().assembly);
    for (std::size_t b = 0; b < motion_.poses().size(); ++b)
      out.polygons.push_back(
          {.outline = outline(b),
           .tint = colours.of(moved_.blocks()[b]),
           .is_held = is_held(moved_.pieces.body(), *moved_.deck.motion, moved_.blocks()[b].region)});
    explain(colours, out);
    return out;
  }

  svg::Figure energies() const {
    const CsvTable table = read_csv(folder_ / "motion.csv");
    svg::Panel panel{.x_label = "time [s]",
                     .y_label = fmt::format("energy [{}]", label(dimension::energy, moved_.deck.units))};
    for (const char* name : {work, kinetic, stored, friction, fracture, damping, impact, numerical}) {
      std::string text = name;
      std::ranges::replace(text, '_', ' ');
      const std::vector<double> values = table.numbers(name);
      if (std::ranges::any_of(values, [](double value) { return value != 0; }))
        panel.series.push_back({.name = text, .x = table.numbers("time"), .y = values});
    }
    svg::Figure out;
    out.panels.push_back(std::move(panel));
    return out;
  }

  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds between_restarts{2};

  MotionRecorder(fs::path folder, const Moved& moved, CurveTable table, ResultsWriter results)
      : folder_(std::move(folder)),
        moved_(moved),
        motion_(moved.motion),
        table_(std::move(table)),
        results_(std::move(results)) {}

  void write_restart_file() {
    written_ = Clock::now();
    at_.motion = motion_.memory();
    write_motion_restart(folder_ / restart_name, at_, deck_);
  }

  const fs::path folder_;
  const Moved moved_;
  const Motion& motion_;
  const std::string deck_ = restart_deck(moved_.deck);
  CurveTable table_;
  ResultsWriter results_;
  MotionRestart at_;
  double every_ = between_frames();  ///< [T]
  Clock::time_point written_ = Clock::now();
};

/// Blocks of second order begin as bodies that the supports do not fit any more: what equilibrium releases then is no
/// energy of the path's, that of the strain gradients is.
nlohmann::ordered_json summary_of(const Beginning& from, const PathEnd& end) {
  nlohmann::ordered_json out{{"is_pushed", from.handover.is_pushed}};
  if (end.equilibrium.num_gradients() == 0)
    out["released_energy"] = from.equilibrium.released;
  else
    out["gradient_energy"] = end.equilibrium.gradient_energy(end.state.d.all());
  out["largest_displacement"] = from.equilibrium.moved;
  if (!from.equilibrium.failure.empty()) out["failure"] = from.equilibrium.failure;
  return out;
}

nlohmann::ordered_json summary_of(const Motion& motion, const Ending& ending, int steps) {
  const MotionLedger& ledger = motion.ledger();
  return {{"folder", "motion"},
          {"is_at_rest", motion.ending() == Motion::Ending::at_rest},
          {"reason", ending.reason},
          {"time", motion.time()},
          {"steps", steps},
          {"rejected_steps", motion.rejected()},
          {"iterations", motion.iterations()},
          {"live_joints", live_joints(motion)},
          {work, ledger.external},
          {kinetic, ledger.kinetic},
          {stored, ledger.stored.sum()},
          {friction, ledger.friction},
          {fracture, ledger.fracture},
          {damping, ledger.damping},
          {impact, ledger.impact},
          {numerical, ledger.numerical},
          {error, ledger.error}};
}

Ending ending_of(const Motion& motion, const MotionParameters& parameters, bool is_interrupted) {
  if (is_interrupted)
    return {Ending::Kind::interrupted, "interrupted in the motion; `dda resume` goes on with it"};
  const bool is_too_long = parameters.time == 0 && motion.ending() == Motion::Ending::at_time,
             has_failed = motion.ending() == Motion::Ending::failed;
  if (is_too_long)
    return {Ending::Kind::stopped_early,
            fmt::format("motion: not at rest after {:.4g} s; `motion.time` gives it longer", motion.time()),
            Stop::not_at_rest};
  return {has_failed ? Ending::Kind::stopped_early : Ending::Kind::goal_reached, "motion: " + motion.reason(),
          motion.stop()};
}

MotionCourse course_of(const MotionParameters& parameters, double time) {
  return {.time = time,
          .stops_at_rest = parameters.stops_at_rest,
          .step = parameters.step,
          .accuracy = parameters.accuracy,
          .integrator = parameters.integrator.make(),
          .damping = parameters.damping};
}

}  // namespace

void copy_motion(const fs::path& from, const RunFolder& to) {
  std::error_code error;
  if (!fs::is_directory(from / "motion", error)) return;
  fs::copy(from / "motion", to.file("motion"),
           fs::copy_options::overwrite_existing | fs::copy_options::recursive, error);
  if (error)
    throw OutputError(fmt::format("cannot copy '{}': {}", (from / "motion").string(), error.message()));
}

MotionRecord run_motion(const RunFolder& run_folder, const Simulation& simulation, const PathEnd& end,
                        const MotionOptions& options) {
  const MotionParameters& parameters = *simulation.deck().motion;
  const fs::path folder = run_folder.file("motion");
  const Pieces pieces(simulation.body(), end.equilibrium, simulation.deck());
  Beginning beginning = begin_motion(pieces, end, parameters);
  Handover& start = beginning.handover;
  Motion motion(start.scene, start.bonds, std::move(start.poses), std::move(start.velocities),
                course_of(parameters, beginning.time));
  motion.set_contacts(std::move(beginning.equilibrium.contacts));
  const auto before = options.goes_on
                          ? read_motion_restart(folder / restart_name, restart_deck(simulation.deck()))
                          : std::nullopt;
  if (before) motion.restore(before->motion, start.bonds);
  MotionRecorder recorder = MotionRecorder::make(
      folder, {simulation.deck(), pieces, motion, end.state.load_factor, beginning.time}, before);
  Progress progress = Progress::for_stream(stderr, options.quiet);
  while (!interrupted() && motion.advance()) {
    const bool is_stored = recorder.record();
    if (progress.keeps_lines() && !is_stored) continue;
    progress.show({.step = recorder.steps(),
                   .load_factor = end.state.load_factor,
                   .control = "motion",
                   .gauges = {{"time", motion.time()}, {kinetic, motion.ledger().kinetic}},
                   .iterations = motion.iterations(),
                   .step_size = motion.step().before,
                   .goal = motion.time() / beginning.time});
  }
  progress.finish();
  recorder.finish();
  const bool is_interrupted = motion.ending() == Motion::Ending::none;
  const Ending ending = ending_of(motion, parameters, is_interrupted);
  nlohmann::ordered_json summary = summary_of(motion, ending, recorder.steps());
  if (end.is_of_path) summary["handover"] = summary_of(beginning, end);
  return {ending, summary};
}

}  // namespace dda
