#include "studies/dda/case/simulation.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <set>

#include "continuation/handover/handover.hpp"
#include "continuation/handover/notices.hpp"
#include "continuation/linear/matrix_quality.hpp"
#include "continuation/ranks/ranks.hpp"
#include "framework/base/memory.hpp"
#include "framework/base/suggestion.hpp"
#include "meshing/mirror.hpp"
#include "studies/dda/case/motion_columns.hpp"
#include "studies/dda/case/stiff_blocks.hpp"

namespace dda {
namespace {

/// A material whose stiffness keeps half of a number's digits: near ν = 1/2 in plane strain, and near −1, stresses are
/// differences of numbers that are larger by 1/(1 − 2ν) and 1/(1 + ν).
std::shared_ptr<const Material> made(const std::string& name, const MaterialChoice& choice, const Deck& deck,
                                     Findings& findings) {
  constexpr double most = 1e7;
  std::shared_ptr<const Material> out = choice.make(deck.plane);
  const Vec3 principal = out->stiffness().selfadjointView<Eigen::Lower>().eigenvalues();
  if (principal.maxCoeff() > most * principal.minCoeff())
    findings.add(choice.where(),
                 fmt::format("materials.{}: so near to its limit `poisson_ratio` leaves no digits for the "
                             "stresses: the stiffnesses in two directions differ {:.1e}-fold, at most "
                             "{:.0e}",
                             name, principal.maxCoeff() / principal.minCoeff(), most));
  return out;
}

/// The materials of the regions; an unknown name is a finding.
std::vector<std::shared_ptr<const Material>> materials_of(const Assembly& assembly, const Deck& deck) {
  Findings findings;
  std::map<std::string, std::shared_ptr<const Material>> made;
  std::vector<std::string> names;
  for (const auto& [name, choice] : deck.material_names) {
    made[name] = dda::made(name, choice, deck, findings);
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

/// Those of the deck that no region is of.
std::vector<std::string> unused_materials(const Assembly& assembly, const Deck& deck) {
  std::vector<std::string> out;
  for (const auto& [name, choice] : deck.material_names)
    if (std::ranges::find(assembly.regions, name, &Region::material) == assembly.regions.end())
      out.push_back(name);
  return out;
}

/// Throws InputError for a solver that the ranks of this run cannot share.
void require_shared_solver(const Deck& deck) {
  constexpr std::string_view shared = "cholmod";
  if (ranks_of_run() && deck.path.linear.name() != shared)
    throw InputError(deck.path.linear.where(),
                     fmt::format("path.linear: several ranks share '{}', not '{}', which is for one", shared,
                                 deck.path.linear.name()));
}

/// The boundaries that are planes of symmetry as sides.
Assembly with_mirrors(Assembly assembly, const Deck& deck) {
  Findings findings;
  std::vector<Mirror> mirrors;
  for (const auto& [name, interface] : deck.interfaces)
    if (!interface.boundary.empty()) mirrors.push_back({interface.boundary, name, interface.where});
  add_mirror_sides(assembly, mirrors, findings);
  if (!mirrors.empty() && !deck.cracks.empty())
    findings.add(mirrors.front().where,
                 "cracks through blocks do not know planes of symmetry; describe the whole structure");
  if (!mirrors.empty() && deck.moves())
    findings.add(mirrors.front().where,
                 "what moves to its end does not stay symmetric: `motion` needs the whole structure");
  findings.throw_if_any();
  return assembly;
}

/// What was adapted, and what a motion does that is easily missed.
std::vector<std::string> first_notices(const Body& body, const Equilibrium& equilibrium, const Deck& deck) {
  std::vector<std::string> out = equilibrium.interfaces().notices;
  std::ranges::move(stiff_blocks(body), std::back_inserter(out));
  if (deck.moves())
    std::ranges::move(motion_notices(body, equilibrium, *deck.motion), std::back_inserter(out));
  return out;
}

bool is_zero(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double x) { return x == 0; });
}

}  // namespace

Simulation::Simulation(const Deck& deck, Timings& timings) : deck_(deck), timings_(timings) {
  require_address_space();
  {
    const auto scope = timings.measure("meshing");
    assembly_ = std::make_unique<const Assembly>(with_mirrors(mesh(deck.scene), deck));
  }
  const auto scope = timings.measure("equilibrium");
  assemble();
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
  if (deck.has_path()) {
    require_control();
    require_shared_solver(deck);
  }
  if (deck.moves()) {
    motion_column::require_free(deck, equilibrium_->interfaces().names);
    require_handover(*body_, *equilibrium_, *deck.motion, deck);
  }
  notices_ = first_notices(*body_, *equilibrium_, deck);
  require_way();
  require_record();
}

void Simulation::assemble() {
  if (!deck_.cracks.empty()) crack_geometry_ = std::make_unique<CrackGeometry>(*assembly_);
  body_ = std::make_unique<const Body>(
      Body{*assembly_, deck_.thickness, materials_of(*assembly_, deck_), crack_geometry_.get(),
           second_order_blocks(*assembly_, deck_.kinematics), unused_materials(*assembly_, deck_)});
  if (crack_geometry_) {
    front_ = std::make_unique<CrackFront>(*crack_geometry_, *body_, deck_);
    front_->begin();
  }
  equilibrium_ = std::make_unique<Equilibrium>(*body_, deck_);
  if (front_) cracked_ = std::make_unique<CrackedStructure>(*front_, *body_, deck_, *equilibrium_);
  if (front_) require_cracks();
}

void Simulation::require_loads() const {
  const std::vector<StageParameters> stages = deck_.loaded_stages();
  if (stages.empty()) return;  // there is no path, only a motion
  const auto takes_away = [&removed = equilibrium_->removed_springs()](std::size_t stage) {
    return std::ranges::find(removed, stage, &ChangingSpring::stage) != removed.end();
  };
  std::vector<const Loading*> loadings;
  for (const auto* part : {&equilibrium_->stages(), &equilibrium_->later_stages()})
    for (const Loading& loading : *part) loadings.push_back(&loading);
  const std::size_t num_dead = equilibrium_->stages().size() - 1, num_held = stages.size() - loadings.size();
  Findings findings;
  for (std::size_t i = 0; i < loadings.size(); ++i) {
    const std::size_t s = i < num_dead ? i : i + num_held;
    if (is_zero(loadings[i]->reference) && is_zero(loadings[i]->reference_offset) && !takes_away(s))
      findings.add(stages[s].where, "stage '" + loadings[i]->name +
                                        "' applies no load: its forces are zero or cancel each other");
  }
  findings.throw_if_any();
}

void Simulation::require_record() const {
  const RecordParameters& record = deck_.record;
  if (record.stiffness && equilibrium_->num_blocks() > RecordParameters::most_stiffness_blocks)
    throw InputError(deck_.where,
                     fmt::format("record.stiffness: the structure has {} blocks; at most {} can be "
                                 "written by contribution",
                                 equilibrium_->num_blocks(), RecordParameters::most_stiffness_blocks));
  if (record.detail)
    for (const Spot& corner : {record.detail->from, record.detail->to}) locate(*assembly_, corner);
  if (record.reference_peak)
    for (const auto& [name, value] : record.reference_peak->at) gauge(name, deck_.where);
}

void Simulation::require_control() const {
  const auto control = deck_.path.control.make(gauges_);
  if (const std::string why = control->refusal(*equilibrium_); !why.empty())
    throw InputError(deck_.path.control.where(), "path.control: " + why);
  Findings findings;
  for (const std::string& key : unheeded_keys(deck_.path, *control)) {
    const auto listed = deck_.listed.find("path." + key);
    const bool is_listed = listed != deck_.listed.end();
    findings.add(is_listed ? listed->second.where : deck_.path.where,
                 fmt::format("{}path.{}{}: control '{}' does not heed it; leave it out, or take another "
                             "`path.control`",
                             is_listed ? listed->second.what + " (" : "", key, is_listed ? ")" : "",
                             deck_.path.control.name()));
  }
  findings.throw_if_any();
}

void Simulation::require_eigenvalues() const {
  const double count = deck_.record.eigenvalues.count,
               unknowns = static_cast<double>(equilibrium_->num_unknowns());
  const double bytes = 2 * count * unknowns * sizeof(double);  // the modes, and the space they are sought in
  if (count > unknowns)
    throw InputError(deck_.where,
                     fmt::format("record.eigenvalues.count: the structure has only {} eigenvalues",
                                 equilibrium_->num_unknowns()));
  if (count > 0 && deck_.record.eigenvalues.mass == EigenvalueMass::density)
    require_density("record.eigenvalues.mass");
  if (bytes > memory_limit())
    throw InputError(deck_.where,
                     fmt::format("record.eigenvalues.count: so many modes need {:.3g} GiB of memory; "
                                 "ask for fewer, or give `--memory-limit` to try it all the same",
                                 bytes / bytes_per_gib));
}

void Simulation::require_density(const std::string& asker) const {
  const auto& materials = body_->materials;
  const auto without = std::ranges::find_if(materials, [](const auto& m) { return m->density() <= 0; });
  if (without == materials.end()) return;
  const Region& region = body_->assembly.regions[static_cast<std::size_t>(without - materials.begin())];
  throw InputError(deck_.record.eigenvalues.where,
                   asker + ": material '" + region.material + "' needs a `density`");
}

void Simulation::prepare() {
  const auto scope = timings_.measure("factorisation");
  system_ = std::make_unique<System>(*equilibrium_, deck_.path.linear, deck_.path.update);
  system_->measure_with(timings_);
  stepper_ = std::make_unique<Stepper>(*system_, deck_.path);
  walker_ = std::make_unique<Walker>(*stepper_);
  if (front_ && front_->is_automatic()) begin_cracks();
  notices_ = first_notices(*body_, *equilibrium_, deck_);
  if (front_) note_coarse_cracks();
  if (const std::size_t multipliers = equilibrium_->num_unknown_multipliers(); multipliers > 0)
    if (const int redundant = num_redundant(equilibrium_->unperturbed()); redundant > 0) {
      notices_.push_back(fmt::format(
          "{} of {} Lagrange multipliers are redundant: their joints are tied more often than their "
          "blocks can move; the perturbation keeps them determined",
          redundant, multipliers));
      hindrance_ = "; " + notices_.back() + "; take `treatment: consistent`";
    }
  if (const auto& locked = equilibrium_->interfaces().locked; !locked.empty())
    hindrance_ = "; " + locked.front();
}

/// Stress of the structure without cracks under the dead loads of a stage, and by its reference load.
BlockStress Simulation::elastic_stress(const Loading& loading) {
  std::vector<double> dead(equilibrium_->num_unknowns()), live(dead.size());
  system_->linear().solve(loading.dead, dead);
  system_->linear().solve(loading.reference, live);
  return cracked_->growing(loading, {dead, 0}, {live, 1});
}

/// Where the first stage asks for a crack that does so; the path moves it to where one is asked for sooner.
void Simulation::begin_cracks() {
  std::vector<BlockStress> elastic{elastic_stress(equilibrium_->stages().back())};
  for (const Loading& later : equilibrium_->later_stages()) elastic.push_back(elastic_stress(later));
  const std::vector<Cut> before = crack_geometry_->cuts();
  front_->begin_where_asked(elastic);
  walker_->follow([&] { return cracked_->remake(before); });
  walker_->begin_stage(equilibrium_->stages().size() - 1);
  look_up();
}

void Simulation::begin_path() {
  path_ = std::make_unique<Path>(*walker_, deck_.path, gauges_, Route{landings(), legs()});
  path_->go_on_with({[this](const StageEnd& end) {
                       if (holds_) holds_(end);
                       hold_loads(end.load_factor);
                       return look_up();
                     },
                     [this] {
                       if (has_held_) has_held_();
                     }});
  if (front_)
    path_->run({*cracked_, [this] { return look_up(); },
                [this] {
                  if (grows_) grows_();
                },
                [this](const Growth& growth) {
                  if (has_grown_) has_grown_(growth);
                }});
}

void Simulation::switch_control() {
  require_control();
  path_->switch_control(look_up());
}

Aims Simulation::look_up() {
  gauges_.gauges = loading().gauges;
  return {gauges_, Route{landings(), legs()}};
}

void Simulation::restore_cracks(const std::vector<Cut>& cuts, std::vector<CrackFront::Memory> memory) {
  const std::vector<Cut> before = crack_geometry_->cuts();
  front_->restore(cuts, std::move(memory));
  walker_->follow([&] { return cracked_->remake(before); });
  look_up();
}

void Simulation::require_cracks() const {
  Findings findings;
  const Position& where = deck_.cracks.front().where;
  if (deck_.path.branch == Branching::to_lowest)
    findings.add(where, "cracks through blocks follow one branch: `path.branch: follow`");
  std::set<std::string> changing;
  for (const auto* springs : {&equilibrium_->added_springs(), &equilibrium_->removed_springs()})
    for (const ChangingSpring& spring : *springs)
      changing.insert(equilibrium_->all_supports()[spring.spring].support);
  for (const auto& [name, support] : deck_.supports)
    if (support.boundary && changing.contains(name))
      findings.add(support.where,
                   fmt::format("support '{}' comes or goes, and cracks through blocks may divide what it "
                               "holds: hold it `at` a point or `over` a patch",
                               name));
  findings.throw_if_any();
}

void Simulation::note_coarse_cracks() {
  constexpr double of_zone = 1.0 / 3;
  const double size = crack_geometry_->block_size();
  for (std::size_t p = 0; p < equilibrium_->num_active(); ++p) {
    const InterfacePoint& point = equilibrium_->point(p);
    const double slope = point.law->steepest_slope();
    if (!point.cut || slope <= 0) continue;
    const double zone = body_->material(point.first).modulus() / (2 * slope);  // l_ch of linear softening
    if (size <= of_zone * zone) return;
    notices_.push_back(fmt::format(
        "cracks through blocks: blocks of size {:.3g} are large beside the cohesive zone's length "
        "E Gf/ft² of {:.3g}; the peak load may be off by several percent, blocks of {:.3g} resolve it",
        size, zone, of_zone * zone));
    return;
  }
}

const Functional& Simulation::gauge(const std::string& name, const Position& where) const {
  std::vector<std::string> names{"load", "load_factor"};
  for (const NamedGauge& gauge : gauges_.gauges) {
    if (gauge.name == name) return gauge.functional;
    names.push_back(gauge.name);
  }
  if (name == "load") return loading().load;
  static const Functional load_factor{.rows = {}, .per_load_factor = 1};
  if (name == "load_factor") return load_factor;
  throw InputError(where, "unknown gauge '" + name + "'" + suggest(name, names));
}

void Simulation::require_way() const {
  const std::vector<Leg> legs = this->legs();
  const std::vector<Landing> landings = this->landings();
  if (legs.empty() || equilibrium_->stages().size() > 1) return;  // dead loads decide where the path starts
  std::vector<Landing> goals = legs.front().until;
  if (legs.size() == 1) std::ranges::copy_if(landings, std::back_inserter(goals), &Landing::ends_leg);
  const State rest{.d = std::vector<double>(equilibrium_->num_unknowns(), 0.0)};
  for (const Landing& goal : goals)
    if (!goal.only_falling && rest.value(goal.gauge) == goal.value)
      throw InputError(deck_.path.where,
                       fmt::format("'{}' is to reach {:g}, where the path starts: it would end, or go by, "
                                   "at once",
                                   goal.name, goal.value));
}

std::vector<Landing> Simulation::landings() const {
  std::vector<Landing> out;
  for (const auto& [name, values] : deck_.record.at)
    for (const double value : values) out.push_back({name, gauge(name, deck_.where), value, false});
  const StopRules& stop = deck_.path.stop;
  for (const auto& [name, value] : stop.gauges)
    out.push_back({name, gauge(name, deck_.path.where), value, true});
  if (!equilibrium_->later_stages().empty())
    return out;  // load factors that end the path are of its last stage
  const Functional load_factor{.rows = {}, .per_load_factor = 1};
  if (stop.load_factor_above) out.push_back({"load_factor", load_factor, *stop.load_factor_above, true});
  if (stop.load_factor_below)
    out.push_back({"load_factor", load_factor, *stop.load_factor_below, true, true});
  return out;
}

std::vector<Leg> Simulation::legs() const {
  std::vector<Leg> out;
  for (const StageParameters& stage : deck_.legs()) {
    Leg leg{.name = stage.name, .has_loads = !stage.loads.empty(), .unloads = stage.unload, .until = {}};
    for (const auto& [name, value] : stage.until)
      leg.until.push_back({name, gauge(name, stage.where), value, true});
    out.push_back(std::move(leg));
  }
  return out;
}

}  // namespace dda
