#include "studies/dda/run/recording/restart.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "framework/files/run/record.hpp"
#include "studies/dda/run/recording/same_structure.hpp"

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

/// Displacements of all nodes, or the combination of kept solutions that they are: from that the same bits follow.
struct DisplacementsRecord {
  bool is_combination = false;
  Numbers d;  ///< of a combination its origin, if it has one
  Numbers z;
  double share = 0, load_factor = 0;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("is_combination", self.is_combination);
    visit("d", self.d);
    visit("z", self.z);
    visit("share", self.share);
    visit("load_factor", self.load_factor);
  }
};

void put_displacements(RestartData& data, const std::string& name, const Displacements& d) {
  DisplacementsRecord record;
  if (const auto sum = LinearSystem::combination_of(d)) {
    record = {.is_combination = true,
              .d = sum->origin ? *sum->origin : Numbers{},
              .z = {sum->z.begin(), sum->z.end()},
              .share = sum->share,
              .load_factor = sum->load_factor};
  } else {
    record.d = d.all();
  }
  put(data, name + ".displacements", record);
}

Displacements take_displacements(const RestartData& data, const std::string& name, LinearSystem& linear) {
  auto record = take<DisplacementsRecord>(data, name + ".displacements");
  if (!record.is_combination) return std::move(record.d);
  return linear.combined(
      {.origin = record.d.empty() ? nullptr : std::make_shared<const Numbers>(std::move(record.d)),
       .share = record.share,
       .load_factor = record.load_factor,
       .z = Eigen::Map<const Eigen::VectorXd>(record.z.data(), std::ssize(record.z))});
}

/// What is stored of a state beside its displacements and history.
struct StateRecord {
  int step = 0;
  double load_factor = 0;
  std::vector<Vec2> multipliers;
  std::vector<Numbers> modes;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("step", self.step);
    visit("load_factor", self.load_factor);
    visit("multipliers", self.multipliers);
    visit("modes", self.modes);
  }
};

void put_state(RestartData& data, const std::string& name, const StoredState& at) {
  const State& state = at.state;
  put(data, name,
      StateRecord{.step = at.step,
                  .load_factor = state.load_factor,
                  .multipliers = state.multipliers,
                  .modes = at.modes});
  put_displacements(data, name, state.d);
  put_all(data, name + ".history", at.history);
}

StoredState take_state(const RestartData& data, const std::string& name, LinearSystem& linear) {
  auto record = take<StateRecord>(data, name);
  return {
      .step = record.step,
      .state = {take_displacements(data, name, linear), record.load_factor, std::move(record.multipliers)},
      .history = take_all<History>(data, name + ".history"),
      .modes = std::move(record.modes)};
}

void put_path(RestartData& data, const PathMemory& m) {
  put(data, "path", m);
  if (m.before) put_state(data, "before", {.step = 0, .state = *m.before, .history = {}, .modes = {}});
  data.texts["path.step_kind"] = {m.step_kind ? to_string(*m.step_kind) : ""};
  auto& names = data.texts["path.travels"] = {};
  Numbers& travels = data.numbers["path.travels"] = {};
  for (const auto& [name, travel] : m.travels) {
    names.push_back(name);
    travels.insert(travels.end(), {travel.from, travel.farthest});
  }
}

PathMemory take_path(const RestartData& data, LinearSystem& linear) {
  auto out = take<PathMemory>(data, "path");
  if (data.numbers.contains("before")) out.before = take_state(data, "before", linear).state;
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
  const std::vector<std::size_t> grown = linear.grown();
  data.integers[name + ".grown"] = {grown.begin(), grown.end()};
}

/// The system with which contacts are solved, which is made when first there are any; each time it makes its columns anew.
constexpr const char* contact_linear = "contact_linear";

/// The linear systems of a path by their names.
std::map<std::string, LinearSystem*> linear_systems(System& system) {
  std::map<std::string, LinearSystem*> out{{"linear", &system.linear()}};
  if (system.iterates_multipliers()) out["path_linear"] = &system.path_linear();
  return out;
}

/// The base that a system had, where there are the cuts with which it was factorised: of their points, the first ones.
void restore_base(const RestartData& data, const std::string& name, LinearSystem& linear,
                  std::size_t points) {
  const std::vector<Mat2> base = matrices(data.numbers.at(name + ".base"));
  if (base.size() < points || !linear.restore(std::span(base).first(points)))
    throw std::runtime_error("the stiffness of the restart file is singular");
}

void restore_columns(const RestartData& data, const std::string& name, LinearSystem& linear) {
  const Integers& updated = data.integers.at(name + ".updated");
  linear.restore_columns(std::vector<std::size_t>(updated.begin(), updated.end()));
}

void put_walker(RestartData& data, const Walker& walker) {
  put_state(data, "here", {walker.effort().accepted, walker.state(), walker.system().history()});
  put(data, "walker", walker.here());
  data.numbers["highest_force_level"] = {walker.system().highest_force_level()};
  put(data, "leaving", walker.leaving());
  put_displacements(data, "leaving", walker.leaving().d);
  put(data, "effort", walker.effort());
  put_linear(data, "linear", walker.system().linear());
  if (walker.system().iterates_multipliers()) put_linear(data, "path_linear", walker.system().path_linear());
  if (const LinearSystem* contact = walker.system().made_contact_linear())
    put_linear(data, contact_linear, *contact);
}

void restore_walker(const RestartData& data, Walker& walker) {
  for (const auto& [name, linear] : linear_systems(walker.system())) restore_columns(data, name, *linear);
  StoredState here = take_state(data, "here", walker.system().linear());
  auto at = take<Candidate>(data, "walker");
  at.state = std::move(here.state);
  at.history = std::move(here.history);
  walker.system().restore_force_level(data.numbers.at("highest_force_level").at(0));
  auto leaving = take<Tangent>(data, "leaving");
  leaving.d = take_displacements(data, "leaving", walker.system().path_linear());
  walker.restore(std::move(at), take<Effort>(data, "effort"), std::move(leaving));
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
  int entry = 0;
  Vec2 tip, direction;
  int aims = 0;
  bool is_stuck = false;

  template <class Self, class Visit>
  static void visit(Self& self, Visit& visit) {
    visit("entry", self.entry);
    visit("tip", self.tip);
    visit("direction", self.direction);
    visit("aims", self.aims);
    visit("is_stuck", self.is_stuck);
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
    records.push_back(
        {static_cast<int>(memory.entry), memory.tip, memory.direction, memory.aims, memory.end.is_stuck});
    ends.push_back(memory.end.reason);
  }
  put_all(data, "cracks", records);
}

std::vector<CrackFront::Memory> take_cracks(const RestartData& data, const fs::path& folder,
                                            const CrackFront& cracks) {
  const auto found = data.texts.find("cracks.end");
  std::vector<CrackFront::Memory> out;
  if (found != data.texts.end())
    for (const CrackRecord& record : take_all<CrackRecord>(data, "cracks"))
      out.push_back({static_cast<std::size_t>(record.entry),
                     record.tip,
                     record.direction,
                     record.aims,
                     {found->second.at(out.size()), record.is_stuck}});
  if (!cracks.may_have(out))
    throw InputError(Position{folder.string()}, "the run had other cracks through its blocks");
  return out;
}

/// Adds how many cuts there were when a base was factorised, and each time when its border had grown.
void add_counts(const RestartData& data, const std::string& name, std::set<std::size_t>& counts) {
  for (const std::int64_t count : data.integers.at(name + ".grown")) counts.insert(std::size_t(count));
}

/// Whether a base was factorised with so many cuts.
bool is_base_at(const RestartData& data, const std::string& name, std::size_t count) {
  return std::size_t(data.integers.at(name + ".grown").front()) == count;
}

/// Makes the cuts again, as many at a time as there were when the bases were factorised, and each time when their
/// borders have grown: a cut changes last digits of what was there before it.
void restore_structure(const RestartData& data, const fs::path& folder, Simulation& simulation) {
  std::vector<Cut> cuts;
  std::vector<CrackFront::Memory> memory;
  if (const CrackFront* cracks = simulation.cracks()) {
    memory = take_cracks(data, folder, *cracks);
    for (const CutRecord& record : take_all<CutRecord>(data, "cuts")) cuts.push_back(record.cut);
  }
  const auto linears = linear_systems(simulation.walker().system());
  std::set<std::size_t> counts{cuts.size()};
  for (const auto& [name, linear] : linears) add_counts(data, name, counts);
  const bool has_contact = data.integers.contains(contact_linear + std::string(".grown"));
  if (has_contact) add_counts(data, contact_linear, counts);
  for (const std::size_t count : counts) {
    if (simulation.cracks())
      simulation.restore_cracks({cuts.begin(), cuts.begin() + std::ptrdiff_t(count)}, memory);
    if (count == cuts.size()) require_same_points(data, folder, simulation.equilibrium());
    for (const auto& [name, linear] : linears)
      if (is_base_at(data, name, count))
        restore_base(data, name, *linear, simulation.equilibrium().num_active());
    if (has_contact && is_base_at(data, contact_linear, count))
      restore_base(data, contact_linear, simulation.walker().system().contact_linear(),
                   simulation.equilibrium().num_active());
  }
}

long long num_factorisations(const Simulation& simulation) {
  return static_cast<long long>(simulation.system().linear().num_factorisations());
}

}  // namespace

RestartData restart_data(const Simulation& simulation, const RunMemory& memory, const DeckFile& deck,
                         const std::string& effective) {
  RestartData out;
  out.integers["unknowns"] = {std::int64_t(simulation.equilibrium().num_unknowns())};
  put_walker(out, simulation.walker());
  put_path(out, simulation.path().memory());
  put_cracks(out, simulation.cracks());
  put(out, "start", memory.start);
  put(out, "peak", memory.peak);
  put_all(out, "first_cracks", memory.first_cracks);
  put_all(out, "grown", memory.grown);
  put_all(out, "stages", memory.stages);
  auto& reasons = out.texts["stages.reason"] = {};
  for (const HeldStage& stage : memory.stages) reasons.push_back(stage.reason);
  const StageHistory& stages = simulation.equilibrium().history();
  out.numbers["held_load_factors"] = stages.held_load_factors;
  out.numbers["supports.rest"] = stages.rest;
  out.numbers["supports.borne"] = stages.borne;
  if (memory.peak_state) put_state(out, "peak_state", *memory.peak_state);
  put(out, "run", memory);
  out.integers["factorisations"] = {memory.num_factorisations + num_factorisations(simulation)};
  put(out, "modes", memory.indicator.modes);
  out.texts["memory_of_laws"] = remembered(simulation.equilibrium());
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
  if (!overrides.empty()) require_same_structure(data.texts.at("deck.effective").at(0), out.deck, folder);
  out.path = data.texts.at("deck.path").at(0);
  out.text = data.texts.at("deck.text").at(0);
  const auto& before = data.texts.at("deck.overrides");
  out.overrides.insert(out.overrides.begin(), before.begin(), before.end());
  return out;
}

RunMemory restore(const RestartData& data, const fs::path& folder, Simulation& simulation) {
  simulation.walker().begin_stage(simulation.equilibrium().stages().size() - 1);
  const auto& n = data.numbers;
  const StageHistory stages{n.at("held_load_factors"), n.at("supports.rest"), n.at("supports.borne")};
  if (stages.held_load_factors.size() >= simulation.deck().followed_stages().size() ||
      take<PathMemory>(data, "path").leg >= std::ssize(simulation.deck().legs()))
    throw InputError(Position{folder.string()}, "the run has gone through more stages than there are now");
  simulation.go_through(stages);
  restore_structure(data, folder, simulation);
  restore_walker(data, simulation.walker());
  simulation.begin_path();
  PathMemory path = take_path(data, simulation.system().linear());
  if (data.texts.at("control").at(0) != to_yaml(simulation.deck().path.control.echo()))
    path.control = path.step = 0;
  simulation.path().restore(path);
  auto out = take<RunMemory>(data, "run");
  out.start = take<Measurement>(data, "start");
  out.peak = take<Measurement>(data, "peak");
  if (data.numbers.contains("peak_state"))
    out.peak_state = take_state(data, "peak_state", simulation.system().linear());
  out.indicator.modes = take<TrackedModes>(data, "modes");
  out.events = nlohmann::ordered_json::parse(data.texts.at("events").at(0));
  const auto& stiffness = data.texts.at("stiffness");
  out.stiffness = {nlohmann::ordered_json::parse(stiffness.at(0)), stiffness.at(1)};
  out.num_factorisations = data.integers.at("factorisations").at(0) - num_factorisations(simulation);
  out.first_cracks = take_all<FirstCrack>(data, "first_cracks");
  out.grown = take_all<GrownSegment>(data, "grown");
  out.stages = take_all<HeldStage>(data, "stages");
  for (std::size_t i = 0; i < out.stages.size(); ++i)
    out.stages[i].reason = data.texts.at("stages.reason").at(i);
  return out;
}

}  // namespace dda
