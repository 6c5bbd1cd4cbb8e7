#include "python/core/follower.hpp"

#include <stdexcept>

#include "continuation/state/history_guard.hpp"
#include "framework/deck/document/node.hpp"
#include "studies/dda/record/failure_indicator.hpp"

namespace dda::python {
namespace {

namespace py = pybind11;

/// Names every place by its keys: "deck: interfaces.joint.law".
void name_places(Node& node, const std::string& name, const std::string& keys) {
  const auto place = [&](const std::string& key) { return keys.empty() ? key : keys + "." + key; };
  node.where = {keys.empty() ? name : name + ": " + keys};
  for (NodeEntry& entry : node.entries) {
    entry.where = {name + ": " + place(entry.key)};
    name_places(entry.value, name, place(entry.key));
  }
  for (std::size_t i = 0; i < node.items.size(); ++i)
    name_places(node.items[i], name, place(std::to_string(i)));
}

DeckFile read(const GivenDeck& deck) {
  DeckSource source{deck.name, deck.text, parse_yaml(deck.text, deck.name)};
  if (deck.is_dictionary) name_places(source.root, deck.name, "");
  return read_deck(std::move(source), deck.settings);
}

/// Raises what a signal handler of Python has raised, KeyboardInterrupt for one; else nothing ends the path.
bool heeds_signals() {
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return false;
}

std::shared_ptr<Followed> made(const GivenDeck& deck) {
  const py::gil_scoped_release unlocked;
  return std::make_shared<Followed>(read(deck));
}

}  // namespace

Follower::Follower(const GivenDeck& deck) : followed_(made(deck)) {
  run().simulation().stepper().break_off_when(heeds_signals);
}

Follower::Turn::Turn(const Follower& of) : of_(of) {
  std::thread::id nobody;
  is_first_ = of_.computes_.compare_exchange_strong(nobody, std::this_thread::get_id());
  of_.require_turn();
}

Follower::Turn::~Turn() {
  if (is_first_) of_.computes_ = std::thread::id{};
}

void Follower::require_turn() const {
  const std::thread::id who = computes_;
  if (who != std::thread::id{} && who != std::this_thread::get_id())
    throw std::runtime_error("another thread follows this path at the moment: a path is for one at a time");
}

std::shared_ptr<AcceptedPoint> Follower::point_here(Point point) const {
  return std::make_shared<AcceptedPoint>(followed_, std::move(point));
}

void Follower::begin(const std::optional<RunOptions>& recorded) {
  const Turn turn(*this);
  const py::gil_scoped_release unlocked;
  if (recorded)
    run().begin(*recorded);
  else
    run().begin();
  run().interrupt_when(heeds_signals);
  Point start;
  run().simulation().path().judge(start);
  here_ = point_here(std::move(start));
}

std::shared_ptr<AcceptedPoint> Follower::next() {
  const Turn turn(*this);
  const py::gil_scoped_release unlocked;
  here_->settle();
  try {
    auto point = run().next();
    if (!point) return nullptr;
    return here_ = point_here(*std::move(point));
  } catch (const py::error_already_set&) {
    run().end({Ending::Kind::interrupted, "interrupted"});
    throw;
  } catch (const std::exception& error) {
    run().end({Ending::Kind::stopped_early, error.what()});
    throw;
  }
}

std::string Follower::conclude() {
  if (!run().is_recorded() || is_concluded_) return "";
  const Turn turn(*this);
  const py::gil_scoped_release unlocked;
  is_concluded_ = true;
  return run().conclude().folder.string();
}

std::string Follower::control() const { return run().deck().deck.path.control.name(); }

void Follower::switch_control(const std::string& yaml) {
  Node chosen = parse_yaml(yaml, "control");
  name_places(chosen, "control", "");
  run().switch_control(controls().choose(chosen));
}

void Follower::go_on_with(const std::string& yaml) {
  Node given = parse_yaml(yaml, "stage");
  name_places(given, "stage", "");
  Findings findings;
  auto stage = stage_kind().read(given, {findings, ".", "stage", "stage"});
  findings.throw_if_any();
  stage->where = given.where;
  const Turn turn(*this);
  const py::gil_scoped_release unlocked;
  run().go_on_with(*std::move(stage));
}

double Follower::next_step() const { return run().simulation().path().next_step(); }

void Follower::set_next_step(double size) {
  if (!(size > 0)) throw py::value_error("next_step is a size: it is larger than 0");
  if (next_step() == 0)
    throw py::value_error(
        "next_step: no step under this control has been taken yet, so that its size has no meaning; "
        "`path.step.first` in the deck is the size of the first one");
  run().simulation().path().set_next_step(size);
}

BlockRows Follower::stiffness() const {
  const Turn turn(*this);
  const py::gil_scoped_release unlocked;
  System& system = followed_->run().simulation().system();
  const Candidate& here = run().simulation().walker().here();
  const HistoryGuard back(system);
  system.set_history(here.history);
  return block_rows(system.stiffness(here.state));
}

StiffnessModes Follower::modes(int count, EigenvalueMass mass) {
  const Turn turn(*this);
  const py::gil_scoped_release unlocked;
  Simulation& simulation = run().simulation();
  if (count < 1 || static_cast<std::size_t>(count) > simulation.equilibrium().num_unknowns())
    throw py::value_error("modes: the count is at least 1 and at most the number of unknowns");
  if (mass == EigenvalueMass::density) simulation.require_density("modes");
  System& system = simulation.system();
  const Candidate& here = simulation.walker().here();
  const HistoryGuard back(system);
  system.set_history(here.history);
  auto found = stiffness_modes(system, here.state, simulation.deck().path.linear,
                               {.count = count, .mass = mass_for(simulation, mass)});
  if (!found) throw std::runtime_error("modes: the stiffness is singular here: a part is free to move");
  return *std::move(found);
}

std::vector<double> Follower::residual() const {
  const Turn turn(*this);
  const py::gil_scoped_release unlocked;
  const System& system = run().simulation().system();
  const State& state = run().simulation().walker().state();
  std::vector<double> out(state.d.size());
  system.residual(state.d.all(), state.load_factor, system.laws(state), out);
  return out;
}

std::vector<double> Follower::load_vector() const {
  const Loading& loading = run().simulation().system().loading();
  const double load_factor = run().simulation().walker().state().load_factor;
  std::vector<double> out = loading.dead;
  for (std::size_t i = 0; i < out.size(); ++i) out[i] += load_factor * loading.reference[i];
  return out;
}

const std::vector<double>& Follower::reference_load() const {
  return run().simulation().system().loading().reference;
}

}  // namespace dda::python
