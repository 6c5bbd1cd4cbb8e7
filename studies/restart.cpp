#include "studies/restart.hpp"

#include <algorithm>

namespace dda {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

Numbers flat(const std::vector<Mat2>& matrices) {
  Numbers out;
  for (const Mat2& m : matrices) out.insert(out.end(), m.data(), m.data() + m.size());
  return out;
}

std::vector<Mat2> matrices(const Numbers& flat) {
  std::vector<Mat2> out;
  for (std::size_t i = 0; i + 3 < flat.size(); i += 4)
    out.emplace_back(Eigen::Map<const Mat2>(flat.data() + i));
  return out;
}

void put(RestartData& data, const std::string& name, const StoredState& at) {
  data.numbers[name + ".d"] = at.state.d;
  data.numbers[name + ".load_factor"] = {at.state.load_factor};
  Numbers& kappa = data.numbers[name + ".kappa"];
  Integers& loading = data.integers[name + ".loading"];
  for (const History& h : at.history) {
    kappa.push_back(h.kappa);
    loading.push_back(h.loading);
  }
  data.integers[name + ".step"] = {at.step};
}

StoredState take_state(const RestartData& data, const std::string& name) {
  StoredState out{.step = static_cast<int>(data.integers.at(name + ".step").at(0)),
                  .state = {data.numbers.at(name + ".d"), data.numbers.at(name + ".load_factor").at(0)},
                  .history = {}};
  const Numbers& kappa = data.numbers.at(name + ".kappa");
  const Integers& loading = data.integers.at(name + ".loading");
  for (std::size_t p = 0; p < kappa.size(); ++p) out.history.push_back({kappa[p], loading.at(p) != 0});
  return out;
}

void put(RestartData& data, const std::string& name, const Measurement& m) {
  Numbers numbers{m.load_factor, m.dissipated, m.stored, m.work, m.load};
  numbers.insert(numbers.end(), m.values.begin(), m.values.end());
  data.numbers[name + ".numbers"] = std::move(numbers);
  data.integers[name + ".counts"] = {m.step, m.newton_iterations};
  data.texts[name + ".control"] = {m.control};
}

Measurement take_measurement(const RestartData& data, const std::string& name) {
  const Numbers& n = data.numbers.at(name + ".numbers");
  const Integers& counts = data.integers.at(name + ".counts");
  return {.step = static_cast<int>(counts.at(0)),
          .load_factor = n.at(0),
          .control = data.texts.at(name + ".control").at(0),
          .newton_iterations = static_cast<int>(counts.at(1)),
          .dissipated = n.at(1),
          .stored = n.at(2),
          .work = n.at(3),
          .load = n.at(4),
          .values = {n.begin() + 5, n.end()}};
}

void put(RestartData& data, const PathMemory& m) {
  data.numbers["path"] = {m.peak_load,   m.step,         m.largest_displacement,
                          m.jump_energy, m.last_quantum, m.unaccounted, m.driver};
  data.integers["path.direction"] = {m.direction};
  data.texts["path.step_control"] = {m.step_control};
}

PathMemory take_path(const RestartData& data) {
  const Numbers& n = data.numbers.at("path");
  return {.peak_load = n.at(0),
          .direction = static_cast<int>(data.integers.at("path.direction").at(0)),
          .step = n.at(1),
          .step_control = data.texts.at("path.step_control").at(0),
          .largest_displacement = n.at(2),
          .jump_energy = n.at(3),
          .last_quantum = n.at(4),
          .unaccounted = n.at(5),
          .driver = n.at(6)};
}

void put(RestartData& data, const Tangent& leaving) {
  data.numbers["leaving.d"] = leaving.d;
  data.numbers["leaving.load_factor"] = {leaving.load_factor};
  data.numbers["leaving.opening_rate"] = leaving.opening_rate;
  data.integers["leaving.dissipates"] = {leaving.dissipates};
}

Tangent take_leaving(const RestartData& data) {
  Tangent out;
  out.d = data.numbers.at("leaving.d");
  out.load_factor = data.numbers.at("leaving.load_factor").at(0);
  out.opening_rate = data.numbers.at("leaving.opening_rate");
  out.dissipates = data.integers.at("leaving.dissipates").at(0) != 0;
  return out;
}

void put(RestartData& data, const Walker& walker) {
  const Candidate& here = walker.here();
  put(data, "here", StoredState{walker.effort().accepted, here.state, walker.system().history()});
  data.numbers["walker"] = {here.dissipated, here.stored,   here.work,
                            here.load,       here.residual, walker.system().highest_force_level()};
  put(data, walker.leaving());
  const Effort& effort = walker.effort();
  data.integers["effort"] = {effort.accepted, effort.rejected, effort.rescues, effort.newton_iterations};
  const LinearSystem& linear = walker.system().linear();
  data.numbers["linear.base"] = flat(linear.base());
  data.integers["linear.updated"] = {linear.updated_points().begin(), linear.updated_points().end()};
}

Effort take_effort(const RestartData& data) {
  const Integers& e = data.integers.at("effort");
  return {.accepted = static_cast<int>(e.at(0)),
          .rejected = static_cast<int>(e.at(1)),
          .rescues = static_cast<int>(e.at(2)),
          .newton_iterations = static_cast<int>(e.at(3))};
}

void check_sizes(const RestartData& data, const fs::path& folder, const Equilibrium& equilibrium) {
  if (data.numbers.at("here.d").size() == equilibrium.num_unknowns() &&
      data.numbers.at("here.kappa").size() == equilibrium.num_crackable())
    return;
  throw InputError(
      Position{folder.string()},
      "the structure has another number of blocks or interface points than the run had; only controls, "
      "stopping rules and records may change");
}

void restore_walker(const RestartData& data, Walker& walker) {
  LinearSystem& linear = walker.system().linear();
  const Integers& updated = data.integers.at("linear.updated");
  const std::vector<std::size_t> points(updated.begin(), updated.end());
  if (!linear.restore(matrices(data.numbers.at("linear.base")), points))
    throw std::runtime_error("the stiffness of the restart file is singular");
  StoredState here = take_state(data, "here");
  const Numbers& n = data.numbers.at("walker");
  const Candidate at{.state = here.state,
                     .history = here.history,
                     .arriving = {},
                     .dissipated = n.at(0),
                     .stored = n.at(1),
                     .work = n.at(2),
                     .load = n.at(3),
                     .residual = n.at(4)};
  walker.system().restore_force_level(n.at(5));
  walker.restore(at, here.history, take_effort(data), take_leaving(data));
}

}  // namespace

RestartData restart_data(const Simulation& simulation, const RunMemory& memory, const DeckFile& deck) {
  RestartData out;
  put(out, simulation.walker());
  put(out, simulation.path().memory());
  put(out, "start", memory.start);
  put(out, "peak", memory.peak);
  if (memory.peak_state) put(out, "peak_state", *memory.peak_state);
  const auto spent = static_cast<std::int64_t>(simulation.system().linear().num_factorisations());
  out.integers["run"] = {memory.last_step, memory.is_peak_stored, memory.num_factorisations + spent};
  out.texts["control"] = {to_yaml(simulation.deck().path.control.echo())};
  out.texts["deck.text"] = {deck.text};
  out.texts["deck.path"] = {fs::absolute(deck.path).string()};
  out.texts["deck.overrides"] = deck.overrides;
  out.texts["deck.effective"] = {to_yaml(deck_schema().echo(deck.deck))};
  return out;
}

DeckFile deck_of(const RestartData& data, const fs::path& folder, const std::vector<std::string>& overrides) {
  DeckFile out =
      deck_from_text(data.texts.at("deck.effective").at(0), folder / "effective_deck.yaml", overrides);
  out.path = data.texts.at("deck.path").at(0);
  out.text = data.texts.at("deck.text").at(0);
  const auto& before = data.texts.at("deck.overrides");
  out.overrides.insert(out.overrides.begin(), before.begin(), before.end());
  return out;
}

RunMemory restore(const RestartData& data, const fs::path& folder, Simulation& simulation) {
  check_sizes(data, folder, simulation.equilibrium());
  simulation.walker().begin_stage(simulation.equilibrium().stages().size() - 1);
  restore_walker(data, simulation.walker());
  simulation.begin_path();
  PathMemory path = take_path(data);
  if (data.texts.at("control").at(0) != to_yaml(simulation.deck().path.control.echo()))
    path.driver = path.step = 0;
  simulation.path().restore(path);
  const Integers& run = data.integers.at("run");
  RunMemory out{.last_step = static_cast<int>(run.at(0)),
                .start = take_measurement(data, "start"),
                .peak = take_measurement(data, "peak"),
                .peak_state = {},
                .is_peak_stored = run.at(1) != 0};
  if (data.numbers.contains("peak_state.d")) out.peak_state = take_state(data, "peak_state");
  out.num_factorisations =
      run.at(2) - static_cast<std::int64_t>(simulation.system().linear().num_factorisations());
  return out;
}

}  // namespace dda
