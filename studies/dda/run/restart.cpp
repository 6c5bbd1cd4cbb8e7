#include "studies/dda/run/restart.hpp"

#include <algorithm>

namespace dda {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

template <class Small>
Numbers flat(const std::vector<Small>& values) {
  Numbers out;
  for (const Small& v : values) out.insert(out.end(), v.data(), v.data() + v.size());
  return out;
}

std::vector<Mat2> matrices(const Numbers& flat) {
  std::vector<Mat2> out;
  for (std::size_t i = 0; i + 3 < flat.size(); i += 4)
    out.emplace_back(Eigen::Map<const Mat2>(flat.data() + i));
  return out;
}

std::vector<Vec2> vectors(const Numbers& flat) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i + 1 < flat.size(); i += 2) out.emplace_back(flat[i], flat[i + 1]);
  return out;
}

/// `count` shapes of one size, cut out of one array.
std::vector<Numbers> shapes(const Numbers& flat, std::size_t count) {
  std::vector<Numbers> out;
  for (std::size_t i = 0; i < count; ++i) {
    const auto size = static_cast<std::ptrdiff_t>(flat.size() / count),
               begin = static_cast<std::ptrdiff_t>(i) * size;
    out.emplace_back(flat.begin() + begin, flat.begin() + begin + size);
  }
  return out;
}

/// Numbers that a point's history is written as.
constexpr std::size_t history_numbers = 17;

void append(const History& h, Numbers& to) {
  to.insert(to.end(), {h.kappa, double(h.loading), double(h.sliding), double(h.phase), h.share, h.slip,
                       h.mixity, h.dissipated, h.opening.x(), h.opening.y(), h.traction.x(), h.traction.y(),
                       h.held.x(), h.held.y(), h.limit.x(), h.limit.y(), h.opened});
}

History history_from(const double* n) {
  return {.kappa = n[0],
          .loading = n[1] != 0,
          .sliding = n[2] != 0,
          .phase = static_cast<int>(n[3]),
          .share = n[4],
          .slip = n[5],
          .mixity = n[6],
          .dissipated = n[7],
          .opening = {n[8], n[9]},
          .traction = {n[10], n[11]},
          .held = {n[12], n[13]},
          .limit = {n[14], n[15]},
          .opened = n[16]};
}

void put(RestartData& data, const std::string& name, const StoredState& at) {
  data.numbers[name + ".d"] = at.state.d;
  data.numbers[name + ".load_factor"] = {at.state.load_factor};
  data.numbers[name + ".multipliers"] = flat(at.state.multipliers);
  Numbers& history = data.numbers[name + ".history"];
  for (const History& h : at.history) append(h, history);
  data.numbers[name + ".modes"] = flat(at.modes);
  data.integers[name + ".step"] = {at.step, static_cast<std::int64_t>(at.modes.size())};
}

StoredState take_state(const RestartData& data, const std::string& name) {
  StoredState out{.step = static_cast<int>(data.integers.at(name + ".step").at(0)),
                  .state = {data.numbers.at(name + ".d"), data.numbers.at(name + ".load_factor").at(0),
                            vectors(data.numbers.at(name + ".multipliers"))},
                  .history = {}};
  const Numbers& history = data.numbers.at(name + ".history");
  for (std::size_t i = 0; i + history_numbers <= history.size(); i += history_numbers)
    out.history.push_back(history_from(history.data() + i));
  out.modes = shapes(data.numbers.at(name + ".modes"),
                     static_cast<std::size_t>(data.integers.at(name + ".step").at(1)));
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

void put(RestartData& data, const std::vector<FirstCrack>& cracks) {
  Numbers& numbers = data.numbers["first_cracks"];
  for (const FirstCrack& crack : cracks)
    numbers.insert(numbers.end(), {double(crack.step), crack.at.x(), crack.at.y()});
}

std::vector<FirstCrack> take_cracks(const RestartData& data) {
  const Numbers& n = data.numbers.at("first_cracks");
  std::vector<FirstCrack> out;
  for (std::size_t i = 0; i + 2 < n.size(); i += 3)
    out.push_back({static_cast<int>(n[i]), {n[i + 1], n[i + 2]}});
  return out;
}

void put(RestartData& data, const PathMemory& m) {
  data.numbers["path"] = {
      m.peak_load, m.step,     m.largest_displacement, m.jump_energy, m.last_quantum, m.unaccounted,
      m.control,   m.leg_peak, m.largest_force,        m.imbalance};
  data.integers["path.counts"] = {m.direction,  m.leg,      m.leg_start,    m.surplus,
                                  m.idle_looks, m.has_slid, m.is_mechanism, m.idle_turn_looks};
  data.texts["path.step_control"] = {m.step_control};
  auto& names = data.texts["path.travels"] = {};
  Numbers& travels = data.numbers["path.travels"] = {};
  for (const auto& [name, travel] : m.travels) {
    names.push_back(name);
    travels.insert(travels.end(), {travel.from, travel.farthest});
  }
}

std::map<std::string, Travel> take_travels(const RestartData& data) {
  std::map<std::string, Travel> out;
  const Numbers& n = data.numbers.at("path.travels");
  std::size_t at = 0;
  for (const std::string& name : data.texts.at("path.travels")) {
    out[name] = {n.at(at), n.at(at + 1)};
    at += 2;
  }
  return out;
}

PathMemory take_path(const RestartData& data) {
  const Numbers& n = data.numbers.at("path");
  return {.peak_load = n.at(0),
          .direction = static_cast<int>(data.integers.at("path.counts").at(0)),
          .step = n.at(1),
          .step_control = data.texts.at("path.step_control").at(0),
          .largest_displacement = n.at(2),
          .jump_energy = n.at(3),
          .last_quantum = n.at(4),
          .unaccounted = n.at(5),
          .control = n.at(6),
          .leg = static_cast<int>(data.integers.at("path.counts").at(1)),
          .leg_start = static_cast<int>(data.integers.at("path.counts").at(2)),
          .surplus = static_cast<int>(data.integers.at("path.counts").at(3)),
          .leg_peak = n.at(7),
          .largest_force = n.at(8),
          .imbalance = n.at(9),
          .travels = take_travels(data),
          .idle_looks = static_cast<int>(data.integers.at("path.counts").at(4)),
          .idle_turn_looks = static_cast<int>(data.integers.at("path.counts").at(7)),
          .has_slid = data.integers.at("path.counts").at(5) != 0,
          .is_mechanism = data.integers.at("path.counts").at(6) != 0};
}

void put(RestartData& data, const Tangent& leaving) {
  data.numbers["leaving.d"] = leaving.d;
  data.numbers["leaving.load_factor"] = {leaving.load_factor};
  data.numbers["leaving.opening"] = flat(leaving.opening);
  data.numbers["leaving.multipliers"] = flat(leaving.multipliers);
  data.integers["leaving.dissipates"] = {leaving.dissipates};
}

Tangent take_leaving(const RestartData& data) {
  Tangent out;
  out.d = data.numbers.at("leaving.d");
  out.load_factor = data.numbers.at("leaving.load_factor").at(0);
  out.opening = vectors(data.numbers.at("leaving.opening"));
  out.multipliers = vectors(data.numbers.at("leaving.multipliers"));
  out.dissipates = data.integers.at("leaving.dissipates").at(0) != 0;
  return out;
}

void put(RestartData& data, const std::string& name, const LinearSystem& linear) {
  data.numbers[name + ".base"] = flat(linear.base());
  data.integers[name + ".updated"] = {linear.updated_points().begin(), linear.updated_points().end()};
}

void put(RestartData& data, const Walker& walker) {
  const Candidate& here = walker.here();
  put(data, "here", StoredState{walker.effort().accepted, here.state, walker.system().history()});
  data.numbers["walker"] = {here.dissipated,
                            here.stored,
                            here.work,
                            here.load,
                            here.residual,
                            walker.system().highest_force_level(),
                            here.arriving.load_factor};
  if (here.num_negative) data.integers["num_negative"] = {*here.num_negative};
  if (here.num_negative_work) data.integers["num_negative_work"] = {*here.num_negative_work};
  put(data, walker.leaving());
  const Effort& effort = walker.effort();
  data.integers["effort"] = {effort.accepted,
                             effort.rejected,
                             effort.rescues,
                             effort.newton_iterations,
                             effort.multiplier_iterations,
                             effort.reduced_iterations,
                             effort.relaxation_iterations};
  put(data, "linear", walker.system().linear());
  if (walker.system().iterates_multipliers()) put(data, "path_linear", walker.system().path_linear());
}

Effort take_effort(const RestartData& data) {
  const Integers& e = data.integers.at("effort");
  return {.accepted = static_cast<int>(e.at(0)),
          .rejected = static_cast<int>(e.at(1)),
          .rescues = static_cast<int>(e.at(2)),
          .newton_iterations = static_cast<int>(e.at(3)),
          .reduced_iterations = static_cast<int>(e.at(5)),
          .multiplier_iterations = static_cast<int>(e.at(4)),
          .relaxation_iterations = static_cast<int>(e.at(6))};
}

void check_sizes(const RestartData& data, const fs::path& folder, const Equilibrium& equilibrium) {
  if (data.numbers.at("here.d").size() == equilibrium.num_unknowns() &&
      data.numbers.at("here.history").size() == history_numbers * equilibrium.num_active())
    return;
  throw InputError(
      Position{folder.string()},
      "the structure has another number of blocks or interface points than the run had; only controls, "
      "stopping rules and records may change");
}

void restore_linear(const RestartData& data, const std::string& name, LinearSystem& linear) {
  const Integers& updated = data.integers.at(name + ".updated");
  const std::vector<std::size_t> points(updated.begin(), updated.end());
  if (!linear.restore(matrices(data.numbers.at(name + ".base")), points))
    throw std::runtime_error("the stiffness of the restart file is singular");
}

void restore_walker(const RestartData& data, Walker& walker) {
  restore_linear(data, "linear", walker.system().linear());
  if (walker.system().iterates_multipliers())
    restore_linear(data, "path_linear", walker.system().path_linear());
  StoredState here = take_state(data, "here");
  const Numbers& n = data.numbers.at("walker");
  Tangent arriving;
  arriving.load_factor = n.at(6);
  Candidate at{.state = here.state,
               .history = here.history,
               .arriving = arriving,
               .dissipated = n.at(0),
               .stored = n.at(1),
               .work = n.at(2),
               .load = n.at(3),
               .residual = n.at(4),
               .num_negative = {},
               .num_negative_work = {}};
  if (const auto found = data.integers.find("num_negative"); found != data.integers.end())
    at.num_negative = static_cast<int>(found->second.at(0));
  if (const auto found = data.integers.find("num_negative_work"); found != data.integers.end())
    at.num_negative_work = static_cast<int>(found->second.at(0));
  walker.system().restore_force_level(n.at(5));
  walker.restore(at, here.history, take_effort(data), take_leaving(data));
}

}  // namespace

RestartData restart_data(const Simulation& simulation, const RunMemory& memory, const DeckFile& deck,
                         const std::string& effective) {
  RestartData out;
  put(out, simulation.walker());
  put(out, simulation.path().memory());
  put(out, "start", memory.start);
  put(out, "peak", memory.peak);
  put(out, memory.first_cracks);
  if (memory.peak_state) put(out, "peak_state", *memory.peak_state);
  const auto spent = static_cast<std::int64_t>(simulation.system().linear().num_factorisations());
  out.numbers["run"] = {memory.largest_gap, memory.indicator.first_stiffness};
  out.numbers["modes.first_values"] = memory.indicator.modes.first_values;
  out.numbers["modes.shapes"] = flat(memory.indicator.modes.shapes);
  out.texts["events"] = {memory.events.dump()};
  out.texts["stiffness"] = {memory.stiffness.numbers.dump(), memory.stiffness.text};
  out.integers["run"] = {memory.last_step, memory.is_peak_stored, memory.num_factorisations + spent,
                         memory.indicator.spare_modes};
  out.texts["control"] = {to_yaml(simulation.deck().path.control.echo())};
  out.texts["deck.text"] = {deck.text};
  out.texts["deck.path"] = {fs::absolute(deck.path).string()};
  out.texts["deck.overrides"] = deck.overrides;
  out.texts["deck.effective"] = {effective};
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
    path.control = path.step = 0;
  simulation.path().restore(path);
  const Integers& run = data.integers.at("run");
  RunMemory out{
      .last_step = static_cast<int>(run.at(0)),
      .start = take_measurement(data, "start"),
      .peak = take_measurement(data, "peak"),
      .peak_state = {},
      .is_peak_stored = run.at(1) != 0,
      .indicator = {data.numbers.at("run").at(1),
                    {data.numbers.at("modes.first_values"),
                     shapes(data.numbers.at("modes.shapes"), data.numbers.at("modes.first_values").size())},
                    static_cast<int>(run.at(3))},
      .events = nlohmann::ordered_json::parse(data.texts.at("events").at(0)),
      .stiffness = {nlohmann::ordered_json::parse(data.texts.at("stiffness").at(0)),
                    data.texts.at("stiffness").at(1)},
      .largest_gap = data.numbers.at("run").at(0),
      .first_cracks = take_cracks(data)};
  if (data.numbers.contains("peak_state.d")) out.peak_state = take_state(data, "peak_state");
  out.num_factorisations =
      run.at(2) - static_cast<std::int64_t>(simulation.system().linear().num_factorisations());
  return out;
}

}  // namespace dda
