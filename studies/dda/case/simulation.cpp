#include "studies/dda/case/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "continuation/detour/dead_load.hpp"
#include "continuation/linear/matrix_quality.hpp"
#include "framework/base/memory.hpp"
#include "framework/base/suggestion.hpp"

namespace dda {
namespace {

/// The materials of the regions; an unknown name is a finding.
std::vector<std::shared_ptr<const Material>> materials_of(const Assembly& assembly, const Deck& deck) {
  Findings findings;
  std::map<std::string, std::shared_ptr<const Material>> made;
  std::vector<std::string> names;
  for (const auto& [name, choice] : deck.material_names) {
    made[name] = choice.make(deck.plane);
    names.push_back(name);
  }
  std::vector<std::shared_ptr<const Material>> out;
  for (const Region& region : assembly.regions) {
    if (!made.contains(region.material))
      findings.add(deck.scene.where, "region '" + region.name + "' is of material '" + region.material +
                                         "', which `materials` does not describe" +
                                         suggest(region.material, names));
    out.push_back(made[region.material]);
  }
  findings.throw_if_any();
  return out;
}

bool is_zero(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return x == 0; });
}

}  // namespace

Simulation::Simulation(const Deck& deck, Timings& timings) : deck_(deck), timings_(timings) {
  {
    const auto scope = timings.measure("meshing");
    assembly_ = std::make_unique<const Assembly>(mesh(deck.scene));
  }
  const auto scope = timings.measure("equilibrium");
  body_ = std::make_unique<const Body>(Body{*assembly_, deck.thickness, materials_of(*assembly_, deck)});
  equilibrium_ = std::make_unique<const Equilibrium>(*body_, deck);
  require_loads();
  require_eigenvalues();
  gauges_.gauges = loading().gauges;
  for (const auto& [name, choice] : deck.gauge_names) {
    if (choice.name() == "displacement" && gauges_.first_displacement.empty())
      gauges_.first_displacement = name;
    if (choice.name() == "relative_displacement" && gauges_.first_opening.empty())
      gauges_.first_opening = name;
  }
  if (deck.path.branch == Branching::to_lowest && equilibrium_->num_unknown_multipliers() > 0)
    throw InputError(deck.path.where,
                     "path.branch: switch is not available with the unknown multipliers of "
                     "'lagrange'; use another treatment");
  if (deck.record.stiffness && equilibrium_->num_blocks() > RecordParameters::most_stiffness_blocks)
    throw InputError(deck.where,
                     fmt::format("record.stiffness: the structure has {} blocks; at most {} can be "
                                 "written by contribution",
                                 equilibrium_->num_blocks(), RecordParameters::most_stiffness_blocks));
  require_control();
  landings();
  legs();
  if (deck.record.detail)
    for (const Spot& corner : {deck.record.detail->from, deck.record.detail->to}) locate(*assembly_, corner);
  if (deck.record.reference_peak)
    for (const auto& [name, value] : deck.record.reference_peak->at) gauge(name, deck.where);
}

void Simulation::require_loads() const {
  const std::vector<StageParameters> stages = deck_.loaded_stages();
  const std::vector<Loading>& loadings = equilibrium_->stages();
  Findings findings;
  for (std::size_t s = 0; s < stages.size(); ++s)
    if (is_zero(loadings[s].reference) && is_zero(loadings[s].reference_offset))
      findings.add(stages[s].where, "stage '" + loadings[s].name +
                                        "' applies no load: its forces are zero or cancel each other");
  findings.throw_if_any();
}

void Simulation::require_control() const {
  const auto control = deck_.path.control.make(gauges_);
  if (const std::string why = control->refusal(*equilibrium_); !why.empty())
    throw InputError(deck_.path.control.where(), "path.control: " + why);
  if (deck_.path.step.sets_sizes() && !control->sizes_steps())
    throw InputError(
        deck_.path.where,
        fmt::format("path.step: the steps of control '{}' have no size that could be set; of this section "
                    "only `accuracy` and `largest` may stay",
                    deck_.path.control.name()));
}

void Simulation::require_eigenvalues() const {
  const double count = deck_.record.eigenvalues.count,
               unknowns = static_cast<double>(equilibrium_->num_unknowns());
  const double bytes = 2 * count * unknowns * sizeof(double);  // the modes, and the space they are sought in
  if (count > unknowns)
    throw InputError(deck_.where,
                     fmt::format("record.eigenvalues.count: the structure has only {} eigenvalues",
                                 equilibrium_->num_unknowns()));
  if (bytes > memory_limit())
    throw InputError(deck_.where,
                     fmt::format("record.eigenvalues.count: so many modes need {:.3g} GiB of memory; "
                                 "ask for fewer, or give `--memory-limit` to try it all the same",
                                 bytes / bytes_per_gib));
}

void Simulation::prepare() {
  const auto scope = timings_.measure("factorisation");
  system_ = std::make_unique<System>(*equilibrium_, deck_.path.linear, deck_.path.update);
  system_->measure_with(timings_);
  stepper_ = std::make_unique<Stepper>(*system_, deck_.path);
  walker_ = std::make_unique<Walker>(*stepper_);
  notices_ = equilibrium_->interfaces().notices;
  if (const std::size_t multipliers = equilibrium_->num_unknown_multipliers(); multipliers > 0)
    if (const int redundant = num_redundant(equilibrium_->unperturbed()); redundant > 0)
      notices_.push_back(fmt::format(
          "{} of {} Lagrange multipliers are redundant: their joints are tied more often than their "
          "blocks can move; the perturbation keeps them determined",
          redundant, multipliers));
}

std::string Simulation::apply_dead_loads() {
  const auto scope = timings_.measure("dead loads");
  const std::size_t stages = equilibrium_->stages().size();
  for (std::size_t stage = 0; stage + 1 < stages; ++stage) {
    walker_->begin_stage(stage);
    if (std::string why = apply_full_stage(*walker_); !why.empty())
      return "stage '" + walker_->system().loading().name + "' cannot be carried: " + why;
  }
  walker_->begin_stage(stages - 1);
  return {};
}

void Simulation::begin_path() {
  path_ = std::make_unique<Path>(*walker_, deck_.path, gauges_, Route{landings(), legs()});
}

const Functional& Simulation::gauge(const std::string& name, const Position& where) const {
  std::vector<std::string> names{"load"};
  for (const NamedGauge& gauge : gauges_.gauges) {
    if (gauge.name == name) return gauge.functional;
    names.push_back(gauge.name);
  }
  if (name == "load") return loading().load;
  throw InputError(where, "unknown gauge '" + name + "'" + suggest(name, names));
}

std::vector<Landing> Simulation::landings() const {
  std::vector<Landing> out;
  for (const auto& [name, values] : deck_.record.at)
    for (const double value : values) out.push_back({name, gauge(name, deck_.where), value, false});
  const StopRules& stop = deck_.path.stop;
  for (const auto& [name, value] : stop.gauges)
    out.push_back({name, gauge(name, deck_.path.where), value, true});
  const Functional load_factor{.rows = {}, .per_load_factor = 1};
  if (stop.load_factor_above) out.push_back({"load_factor", load_factor, *stop.load_factor_above, true});
  if (stop.load_factor_below)
    out.push_back({"load_factor", load_factor, *stop.load_factor_below, true, true});
  return out;
}

std::vector<Leg> Simulation::legs() const {
  std::vector<Leg> out;
  for (const StageParameters& stage : deck_.legs()) {
    Leg leg{stage.name, stage.unload, {}};
    for (const auto& [name, value] : stage.until)
      leg.until.push_back({name, gauge(name, stage.where), value, true});
    out.push_back(std::move(leg));
  }
  return out;
}

}  // namespace dda
