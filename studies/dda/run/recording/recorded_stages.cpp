// What a run's record knows of stages whose loads are followed one after another, and the tables that hang on how many these are.
#include <algorithm>
#include <iterator>

#include "framework/files/run/results_reader.hpp"
#include "framework/messages/provenance.hpp"
#include "studies/dda/case/model_tables.hpp"
#include "studies/dda/run/recording/run_recorder.hpp"

namespace dda {
namespace {

RecordedColumns joined(RecordedColumns first, const RecordedColumns& second) {
  std::ranges::copy(second, std::back_inserter(first));
  return first;
}

/// Numbers in the deck of the stages that are followed, as the model's tables have them: of one none.
std::vector<std::int64_t> told_apart(const Deck& deck) {
  std::vector<std::int64_t> out;
  for (const std::size_t stage : deck.followed_stages()) out.push_back(static_cast<std::int64_t>(stage) + 1);
  if (out.size() < 2) out.clear();
  return out;
}

/// Gives a table of rows that are all of the first stage the column that says so.
void tell_stages_apart(const std::filesystem::path& curve, const RecordedColumns& columns, const Deck& deck) {
  const auto of_stage = std::ranges::find(columns, column::stage, &Column::name);
  if (of_stage == columns.end() || read_csv(curve).has(column::stage)) return;
  CurveTable::add_column(curve, *of_stage, static_cast<std::size_t>(of_stage - columns.begin()),
                         told_apart(deck).front());
}

}  // namespace

Measures RunRecorder::measures_here() const {
  const Deck& deck = simulation_.deck();
  const Loading& loading = simulation_.loading();
  Dimension dimension = loading.all_are_forces ? dimension::force : dimension::none;
  for (const NamedGauge& gauge : loading.gauges)
    if (gauge.name == deck.path.load_gauge) dimension = gauge.dimension;
  return {loading, simulation_.path().load_gauge(), unit_of(dimension, deck.units), deck.units,
          columns_of_parts()};
}

RecordedColumns RunRecorder::columns_of_parts() const {
  return joined(columns_of_stages(), joined(interfaces_.columns(), indicator_.columns()));
}

RecordedColumns RunRecorder::columns_of_rows() const {
  RecordedColumns out = joined(measures_.columns(), columns_of_parts());
  std::erase_if(out, [](const RecordedColumn& column) { return !column.cell; });
  return out;
}

RecordedColumns RunRecorder::columns_of_stages() const {
  if (stage_number() == 0) return {};
  return {{{column::stage, ""}, [this](const RecordedStep&) { return std::int64_t{stage_number()}; }}};
}

int RunRecorder::stage_number() const {
  if (simulation_.deck().followed_stages().size() < 2) return 0;
  return static_cast<int>(simulation_.followed_stage()) + 1;
}

CurveTable RunRecorder::open_curve(bool is_new) const {
  const auto file = folder_.file("curve.csv");
  const std::vector<Column> columns(columns_.begin(), columns_.end());
  if (is_new) return {file, columns};
  tell_stages_apart(file, columns_, simulation_.deck());
  return CurveTable::resume(file, columns, static_cast<std::size_t>(memory_.last_step) + 1);
}

ResultsMesh RunRecorder::mesh() const {
  ResultsMesh out = fields_.mesh();
  out.model = model_tables(simulation_.body(), simulation_.deck(), simulation_.equilibrium());
  return out;
}

ResultsTexts RunRecorder::texts() const {
  auto out = to_texts(provenance());
  out["deck"] = deck_.text;
  out["effective_deck"] = effective_;
  return out;
}

void RunRecorder::renew_stages() {
  if (ResultsReader(folder_.path()).model("followed_stages") == told_apart(simulation_.deck())) return;
  results_.renew(mesh(), texts());
  has_new_stages_ = true;
}

void RunRecorder::go_on_with_stage(std::string effective) {
  effective_ = std::move(effective);
  memory_.events = events_.list();
  write_restart_file();  // before the tables, which a restart brings up to it
  columns_ = columns_of_rows();
  curve_ = open_curve(false);
  renew_stages();
}

/// What it has stored is drawn and checked with its own loads.
void RunRecorder::end_stage(const StageEnd& end) {
  const auto scope = timings_.measure("output");
  store_peak();
  store_here();
  memory_.peak_state.reset();
  memory_.is_peak_stored = true;
  events_.number_stages(stage_number());
  const bool has_rows = memory_.peak_stage == static_cast<int>(memory_.stages.size());
  memory_.stages.push_back({.number = stage_number(),
                            .end = memory_.last_step,
                            .load_factor = end.load_factor,
                            .load = last_.load,
                            .peak_step = has_rows ? memory_.peak.step : memory_.last_step,
                            .peak_load = has_rows ? memory_.peak.load : 0,
                            .reason = end.reason});
}

void RunRecorder::begin_stage() {
  measures_ = measures_here();
  memory_.stages.back().next = {stage_number(), simulation_.walker().here().load};
  events_.begin_stage(simulation_.walker());
  events_.number_stages(stage_number());
  trace_.push_back(trace_point(simulation_.walker(), measures_));
}

}  // namespace dda
