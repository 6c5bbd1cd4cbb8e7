#include "studies/dda/run/recording/summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "continuation/linear/matrix_quality.hpp"
#include "continuation/linear/strips/strip_part.hpp"
#include "framework/base/threads.hpp"
#include "framework/messages/provenance.hpp"
#include "framework/plugin/plugin.hpp"
#include "studies/dda/record/column_names.hpp"
#include "studies/dda/record/path/events.hpp"
#include "studies/dda/record/path/peak.hpp"
#include "studies/dda/record/path/small_extrema.hpp"

namespace dda {
namespace {

using Json = nlohmann::ordered_json;

Json gauges_at(const Measurement& at, const Measures& measures) {
  Json out = Json::object();
  for (std::size_t i = 0; i < measures.num_gauges(); ++i) out[measures.names()[i].name] = at.values[i];
  return out;
}

/// JSON knows no infinity: nlohmann-json writes it as null.
Json to_json(const MatrixQuality& quality) {
  return {{"condition", quality.condition},
          {"smallest_pivot", quality.smallest_pivot},
          {"largest_pivot", quality.largest_pivot},
          {"negative_pivots", quality.negative_pivots},
          {"null_pivots", quality.null_pivots}};
}

/// How far the peak is from that of a straight crack, say: what the blocks' pattern adds.
void add_mesh_bias(const std::optional<ReferencePeak>& reference, double peak, Json& out) {
  if (!reference) return;
  out["reference_peak"] = {{"load", reference->load}, {"text", reference->text}, {"at", reference->at}};
  out["mesh_bias"] = std::abs(peak) / reference->load - 1;
}

/// One after another, the last one as far as it has come; where there is but one the load factor says all.
void add_stages(const Simulation& simulation, const RunMemory& memory, const Measurement& end, Json& out) {
  const Deck& deck = simulation.deck();
  if (deck.followed_stages().size() < 2) return;
  const auto name = [&](int number) { return deck.stages[static_cast<std::size_t>(number) - 1].name; };
  double start = 0;
  for (const HeldStage& stage : memory.stages) {
    out["stages"].push_back({{"number", stage.number},
                             {"name", name(stage.number)},
                             {"start_load", start},
                             {"end", stage.end},
                             {"load_factor", stage.load_factor},
                             {"load", stage.load},
                             {"reason", stage.reason},
                             {"peak", {{"step", stage.peak_step}, {"load", stage.peak_load}}}});
    start = stage.next.load;
  }
  const int number = static_cast<int>(simulation.followed_stage()) + 1;
  out["stages"].push_back({{"number", number},
                           {"name", name(number)},
                           {"start_load", start},
                           {"end", memory.last_step},
                           {"load_factor", end.load_factor},
                           {"load", end.load}});
}

Json units_of(const Units& units) { return {{"length", units.length}, {"force", units.force}}; }

}  // namespace

std::string status_of(const Ending& ending) {
  switch (ending.kind) {
    case Ending::Kind::goal_reached:
      return "goal_reached";
    case Ending::Kind::interrupted:
      return "interrupted";
    case Ending::Kind::running:
    case Ending::Kind::stopped_early:
      break;
  }
  return "stopped_early";
}

std::string what_now(const Ending& ending) {
  return ending.stop ? fmt::format("; what now: `dda explain {}`", to_string(*ending.stop)) : "";
}

int exit_code_of(const Ending& ending) {
  if (ending.kind == Ending::Kind::goal_reached) return 0;
  return ending.kind == Ending::Kind::interrupted ? 130 : 3;
}

double energy_balance_error(const Measurement& start, const Measurement& end, double jump_energy,
                            double largest_work) {
  const double work = end.work - start.work, most = std::max(std::abs(work), largest_work);
  if (most == 0) return 0;
  const double stored = end.stored - start.stored, dissipated = end.dissipated - start.dissipated;
  return std::abs(work - stored - dissipated - jump_energy) / most;
}

Json peak_of(const RunMemory& memory, const Measures& measures) {
  const Measurement& peak = memory.peak;
  Json out{{"step", peak.step}, {"load_factor", peak.load_factor}, {"load", peak.load}};
  out["gauges"] = gauges_at(peak, measures);
  return out;
}

Json events_with_peaks(const RunMemory& memory, const Measures& measures, const CsvTable& curve) {
  const Json last = peak_of(memory, measures);
  Json out = passed_events(memory.events);
  for (const auto& stage : memory.stages) {
    const auto at = static_cast<std::size_t>(stage.peak_step);
    Json peak = last;
    peak["step"] = stage.peak_step;
    for (const char* name : {column::load_factor, column::load}) peak[name] = curve.numbers(name).at(at);
    for (auto& [name, value] : peak["gauges"].items()) value = curve.numbers(name).at(at);
    out = with_peak(std::move(out), peak, curve);
  }
  return with_peak(std::move(out), last, curve);
}

Json stiffness_quality(const Simulation& simulation) {
  return {{"start", to_json(assess(simulation.equilibrium().intact()))},
          {"end", to_json(assess(simulation.system().stiffness(simulation.walker().state())))}};
}

Json to_json(const Timings& timings) {
  Json out = Json::object();
  for (const Timings::Phase& phase : timings.phases()) out[phase.name] = phase.seconds;
  out["total"] = timings.total();
  out["start_up"] = timings.start_up();
  return out;
}

Json to_json(Ranks& ranks) {
  constexpr double bytes_per_mib = 1024 * 1024;
  std::vector<double> memory = memory_by_rank(ranks);
  for (double& bytes : memory) bytes /= bytes_per_mib;
  const Traffic& traffic = ranks.traffic();
  return {{"count", ranks.size()},
          {"peak_memory_mib", memory},
          {"exchanges", traffic.exchanges},
          {"sent_mib", static_cast<double>(traffic.sent) / bytes_per_mib},
          {"received_mib", static_cast<double>(traffic.received) / bytes_per_mib}};
}

namespace {

void add_effort(const Effort& effort, Json& out) {
  out["steps"] = effort.accepted;
  out["rejected_steps"] = effort.rejected;
  out["cracked_steps"] = effort.cracked_steps;
  out["whole_steps"] = effort.whole_steps;
  out["whole_iterations"] = effort.newton_iterations;
  out["reduced_iterations"] = effort.reduced_iterations;
  out["relaxation_iterations"] = effort.relaxation_iterations;
}

}  // namespace

std::int64_t iterations_of(const CsvTable& curve) {
  const std::vector<double> all = curve.numbers("newton_iterations");
  return std::llround(std::accumulate(all.begin(), all.end(), 0.0));
}

void add_program(Json& summary) {
  summary["version"] = provenance().version;
  for (const std::filesystem::path& plugin : loaded_plugins()) summary["plugins"].push_back(plugin.string());
}

Json summarise(const Simulation& simulation, const RunMemory& memory, const Measures& measures,
               const Ending& ending) {
  const Walker& walker = simulation.walker();
  const Effort& effort = walker.effort();
  const Equilibrium& equilibrium = simulation.equilibrium();
  const double jump_energy = simulation.path().memory().jump_energy;
  const Measurement end = measures.measure(walker, effort.accepted, "", 0);
  Json out{{"title", simulation.deck().title}, {"status", status_of(ending)}, {"reason", ending.reason}};
  if (ending.stop) out["stop"] = to_string(*ending.stop);
  out["blocks"] = equilibrium.num_blocks();
  out["interface_points"] = equilibrium.num_points();
  out["crackable_points"] = equilibrium.interfaces().num_crackable();
  out["unknowns"] = equilibrium.num_unknowns();
  add_effort(effort, out);
  out["factorisations"] =
      memory.num_factorisations + static_cast<long long>(simulation.system().linear().num_factorisations());
  out["rescues"] = effort.rescues;
  if (simulation.system().iterates_multipliers()) {
    out["multiplier_iterations"] = effort.multiplier_iterations;
    out["largest_gap"] = memory.largest_gap;
  }
  out["peak"] = peak_of(memory, measures);
  add_mesh_bias(simulation.deck().record.reference_peak, memory.peak.load, out);
  add_stages(simulation, memory, end, out);
  out["external_work"] = end.work;
  out["stored_energy"] = end.stored;
  out["dissipated_energy"] = end.dissipated;
  const ListedEvents events = listed_events(memory.events, memory.start, end, measures.names());
  out["events"] = events.listed;
  if (!events.small.is_null()) out["small_extrema"] = events.small;
  const Balance& balance = simulation.path().memory().balance;
  const double most = std::max(std::abs(end.work), balance.largest_work);
  out["energy_balance_error"] = energy_balance_error(memory.start, end, jump_energy, balance.largest_work);
  out["energy_balance_scatter"] = most == 0 ? 0.0 : balance.unaccounted / most;
  out["jump_energy"] = jump_energy;
  out["units"] = units_of(simulation.deck().units);
  out["threads"] = num_threads();
  add_program(out);
  return out;
}

}  // namespace dda
