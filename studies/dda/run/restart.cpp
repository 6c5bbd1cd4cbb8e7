#include "studies/dda/run/restart.hpp"

#include <algorithm>

#include "framework/files/record.hpp"

namespace dda {
namespace {

namespace fs = std::filesystem;
using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

Numbers flat(const std::vector<Mat2>& values) {
  Numbers out;
  for (const Mat2& v : values) out.insert(out.end(), v.data(), v.data() + v.size());
  return out;
}

std::vector<Mat2> matrices(const Numbers& flat) {
  std::vector<Mat2> out;
  for (std::size_t i = 0; i + 3 < flat.size(); i += 4)
    out.emplace_back(Eigen::Map<const Mat2>(flat.data() + i));
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

/// What is stored of a state beside its history and modes.
struct StateRecord {
  int step = 0, num_modes = 0;
  Numbers d;
  std::optional<double> dead_work;
  double load_factor = 0;
  std::vector<Vec2> multipliers;
  Numbers modes;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("step", self.step);
    visit("num_modes", self.num_modes);
    visit("d", self.d);
    visit("dead_work", self.dead_work);
    visit("load_factor", self.load_factor);
    visit("multipliers", self.multipliers);
    visit("modes", self.modes);
  }
};

void put_state(RestartData& data, const std::string& name, const StoredState& at) {
  const State& state = at.state;
  StateRecord record{.step = at.step,
                     .num_modes = static_cast<int>(at.modes.size()),
                     .d = state.d,
                     .dead_work = state.d.dead_work(),
                     .load_factor = state.load_factor,
                     .multipliers = state.multipliers,
                     .modes = {}};
  for (const Numbers& shape : at.modes) record.modes.insert(record.modes.end(), shape.begin(), shape.end());
  put(data, name, record);
  put_all(data, name + ".history", at.history);
}

StoredState take_state(const RestartData& data, const std::string& name) {
  auto record = take<StateRecord>(data, name);
  return {.step = record.step,
          .state = {{std::move(record.d), nullptr, nullptr, record.dead_work},
                    record.load_factor,
                    std::move(record.multipliers)},
          .history = take_all<History>(data, name + ".history"),
          .modes = shapes(record.modes, static_cast<std::size_t>(record.num_modes))};
}

void put_path(RestartData& data, const PathMemory& m) {
  put(data, "path", m);
  data.texts["path.step_kind"] = {m.step_kind ? to_string(*m.step_kind) : ""};
  auto& names = data.texts["path.travels"] = {};
  Numbers& travels = data.numbers["path.travels"] = {};
  for (const auto& [name, travel] : m.travels) {
    names.push_back(name);
    travels.insert(travels.end(), {travel.from, travel.farthest});
  }
}

PathMemory take_path(const RestartData& data) {
  auto out = take<PathMemory>(data, "path");
  out.step_kind = step_kind(data.texts.at("path.step_kind").at(0));
  const Numbers& n = data.numbers.at("path.travels");
  std::size_t at = 0;
  for (const std::string& name : data.texts.at("path.travels")) {
    out.travels[name] = {n.at(at), n.at(at + 1)};
    at += 2;
  }
  return out;
}

void put_linear(RestartData& data, const std::string& name, const LinearSystem& linear) {
  data.numbers[name + ".base"] = flat(linear.base());
  data.integers[name + ".updated"] = {linear.updated_points().begin(), linear.updated_points().end()};
}

void restore_linear(const RestartData& data, const std::string& name, LinearSystem& linear) {
  const Integers& updated = data.integers.at(name + ".updated");
  const std::vector<std::size_t> points(updated.begin(), updated.end());
  if (!linear.restore(matrices(data.numbers.at(name + ".base")), points))
    throw std::runtime_error("the stiffness of the restart file is singular");
}

/// What is stored of the walker's candidate beside its state.
struct WalkerRecord {
  double dissipated = 0, stored = 0, work = 0, load = 0, residual = 0;
  double arriving_load_factor = 0, highest_force_level = 0;
  std::optional<int> num_negative, num_negative_work;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("dissipated", self.dissipated);
    visit("stored", self.stored);
    visit("work", self.work);
    visit("load", self.load);
    visit("residual", self.residual);
    visit("arriving_load_factor", self.arriving_load_factor);
    visit("highest_force_level", self.highest_force_level);
    visit("num_negative", self.num_negative);
    visit("num_negative_work", self.num_negative_work);
  }
};

void put_walker(RestartData& data, const Walker& walker) {
  const Candidate& here = walker.here();
  put_state(data, "here", {walker.effort().accepted, here.state, walker.system().history()});
  put(data, "walker",
      WalkerRecord{.dissipated = here.dissipated,
                   .stored = here.stored,
                   .work = here.work,
                   .load = here.load,
                   .residual = here.residual,
                   .arriving_load_factor = here.arriving.load_factor,
                   .highest_force_level = walker.system().highest_force_level(),
                   .num_negative = here.num_negative,
                   .num_negative_work = here.num_negative_work});
  put(data, "leaving", walker.leaving());
  put(data, "effort", walker.effort());
  put_linear(data, "linear", walker.system().linear());
  if (walker.system().iterates_multipliers()) put_linear(data, "path_linear", walker.system().path_linear());
}

void restore_walker(const RestartData& data, Walker& walker) {
  restore_linear(data, "linear", walker.system().linear());
  if (walker.system().iterates_multipliers())
    restore_linear(data, "path_linear", walker.system().path_linear());
  StoredState here = take_state(data, "here");
  const auto record = take<WalkerRecord>(data, "walker");
  Tangent arriving;
  arriving.load_factor = record.arriving_load_factor;
  const Candidate at{.state = here.state,
                     .history = here.history,
                     .arriving = arriving,
                     .dissipated = record.dissipated,
                     .stored = record.stored,
                     .work = record.work,
                     .load = record.load,
                     .residual = record.residual,
                     .num_negative = record.num_negative,
                     .num_negative_work = record.num_negative_work};
  walker.system().restore_force_level(record.highest_force_level);
  walker.restore(at, std::move(here.history), take<Effort>(data, "effort"), take<Tangent>(data, "leaving"));
}

/// What is stored of a cut.
struct CutRecord {
  Cut cut;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    auto block = static_cast<int>(self.cut.block.value());
    auto side = self.cut.side ? std::optional<int>(static_cast<int>(*self.cut.side)) : std::nullopt;
    visit("block", block);
    visit("start", self.cut.start);
    visit("end", self.cut.end);
    visit("crack", self.cut.crack);
    visit("side", side);
    visit("is_provisional", self.cut.is_provisional);
    if constexpr (!std::is_const_v<Self>) {
      self.cut.block = BlockId{static_cast<std::size_t>(block)};
      self.cut.side = side ? std::optional(static_cast<std::size_t>(*side)) : std::nullopt;
    }
  }
};

/// What is stored of a crack beside its cuts.
struct CrackRecord {
  Vec2 tip, direction;
  int aims = 0;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("tip", self.tip);
    visit("direction", self.direction);
    visit("aims", self.aims);
  }
};

void put_cracks(RestartData& data, const CrackFront* cracks) {
  if (!cracks) return;
  std::vector<CutRecord> cuts;
  for (const Cut& cut : cracks->geometry().cuts()) cuts.push_back({cut});
  put_all(data, "cuts", cuts);
  std::vector<CrackRecord> records;
  auto& ends = data.texts["cracks.end"] = {};
  for (const CrackFront::Memory& memory : cracks->memory()) {
    records.push_back({memory.tip, memory.direction, memory.aims});
    ends.push_back(memory.end);
  }
  put_all(data, "cracks", records);
}

void restore_cracks(const RestartData& data, const fs::path& folder, Simulation& simulation) {
  if (!simulation.cracks()) return;
  const auto found = data.texts.find("cracks.end");
  if (found == data.texts.end() || found->second.size() != simulation.cracks()->num_cracks())
    throw InputError(Position{folder.string()}, "the run had other cracks through its blocks");
  std::vector<Cut> cuts;
  for (const CutRecord& record : take_all<CutRecord>(data, "cuts")) cuts.push_back(record.cut);
  std::vector<CrackFront::Memory> memory;
  for (const CrackRecord& record : take_all<CrackRecord>(data, "cracks"))
    memory.push_back({record.tip, record.direction, record.aims, found->second.at(memory.size())});
  simulation.restore_cracks(cuts, std::move(memory));
}

void check_sizes(const RestartData& data, const fs::path& folder, const Equilibrium& equilibrium) {
  const std::size_t width = data.texts.at("here.history.members").size();
  if (data.numbers.at("here.d").size() == equilibrium.num_unknowns() &&
      data.numbers.at("here.history").size() == width * equilibrium.num_active())
    return;
  throw InputError(
      Position{folder.string()},
      "the structure has another number of blocks or interface points than the run had; only controls, "
      "stopping rules and records may change");
}

/// What is stored of a run beside its path and its events.
struct RunRecord {
  int last_step = 0;
  bool is_peak_stored = true;
  long long num_factorisations = 0;
  double largest_gap = 0, first_stiffness = 0;
  int spare_modes = 0;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("last_step", self.last_step);
    visit("is_peak_stored", self.is_peak_stored);
    visit("num_factorisations", self.num_factorisations);
    visit("largest_gap", self.largest_gap);
    visit("first_stiffness", self.first_stiffness);
    visit("spare_modes", self.spare_modes);
  }
};

void put_modes(RestartData& data, const TrackedModes& modes) {
  data.numbers["modes.first_values"] = modes.first_values;
  Numbers& all = data.numbers["modes.shapes"] = {};
  for (const auto& shape : modes.shapes) all.insert(all.end(), shape.begin(), shape.end());
}

TrackedModes take_modes(const RestartData& data) {
  const Numbers& values = data.numbers.at("modes.first_values");
  return {values, shapes(data.numbers.at("modes.shapes"), values.size())};
}

}  // namespace

RestartData restart_data(const Simulation& simulation, const RunMemory& memory, const DeckFile& deck,
                         const std::string& effective) {
  RestartData out;
  put_walker(out, simulation.walker());
  put_path(out, simulation.path().memory());
  put_cracks(out, simulation.cracks());
  put(out, "start", memory.start);
  put(out, "peak", memory.peak);
  put_all(out, "first_cracks", memory.first_cracks);
  if (memory.peak_state) put_state(out, "peak_state", *memory.peak_state);
  const auto spent = static_cast<long long>(simulation.system().linear().num_factorisations());
  put(out, "run",
      RunRecord{.last_step = memory.last_step,
                .is_peak_stored = memory.is_peak_stored,
                .num_factorisations = memory.num_factorisations + spent,
                .largest_gap = memory.largest_gap,
                .first_stiffness = memory.indicator.first_stiffness,
                .spare_modes = memory.indicator.spare_modes});
  put_modes(out, memory.indicator.modes);
  out.texts["events"] = {memory.events.dump()};
  out.texts["stiffness"] = {memory.stiffness.numbers.dump(), memory.stiffness.text};
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
  restore_cracks(data, folder, simulation);
  check_sizes(data, folder, simulation.equilibrium());
  simulation.walker().begin_stage(simulation.equilibrium().stages().size() - 1);
  restore_walker(data, simulation.walker());
  simulation.begin_path();
  PathMemory path = take_path(data);
  if (data.texts.at("control").at(0) != to_yaml(simulation.deck().path.control.echo()))
    path.control = path.step = 0;
  simulation.path().restore(path);
  const auto run = take<RunRecord>(data, "run");
  RunMemory out{.last_step = run.last_step,
                .start = take<Measurement>(data, "start"),
                .peak = take<Measurement>(data, "peak"),
                .peak_state = {},
                .is_peak_stored = run.is_peak_stored,
                .indicator = {run.first_stiffness, take_modes(data), run.spare_modes},
                .events = nlohmann::ordered_json::parse(data.texts.at("events").at(0)),
                .stiffness = {nlohmann::ordered_json::parse(data.texts.at("stiffness").at(0)),
                              data.texts.at("stiffness").at(1)},
                .largest_gap = run.largest_gap,
                .first_cracks = take_all<FirstCrack>(data, "first_cracks")};
  if (data.numbers.contains("peak_state.d")) out.peak_state = take_state(data, "peak_state");
  out.num_factorisations =
      run.num_factorisations - static_cast<long long>(simulation.system().linear().num_factorisations());
  return out;
}

}  // namespace dda
