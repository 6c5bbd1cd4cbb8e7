#include <fmt/format.h>

#include <cmath>
#include <map>

#include "continuation/handover/regions.hpp"
#include "models/equilibrium/loading.hpp"
#include "studies/dda/case/deck/written_deck.hpp"
#include "studies/dda/case/predicted_memory.hpp"
#include "studies/dda/commands/commands.hpp"
#include "studies/dda/figures/figure_file.hpp"
#include "studies/dda/figures/model_picture.hpp"
#include "studies/dda/record/warnings/bearings.hpp"
#include "studies/dda/record/warnings/coarse_zones.hpp"
#include "studies/dda/record/warnings/cracks_left_out.hpp"
#include "studies/dda/record/warnings/unlikely_numbers.hpp"
#include "studies/dda/sweep/description/sweep.hpp"

namespace dda {
namespace {

constexpr double bytes_per_mib = 1024.0 * 1024.0;

void line(const std::string& name, const std::string& text) { fmt::print("  {:<18}{}\n", name, text); }

std::string list(const std::map<std::size_t, std::size_t>& blocks_by_corners) {
  std::string out;
  for (const auto& [corners, count] : blocks_by_corners)
    out += fmt::format("{}{} with {} corners", out.empty() ? "" : ", ", count, corners);
  return out;
}

void print_blocks(const Simulation& simulation) {
  const Assembly& assembly = simulation.assembly();
  const Quality quality = assess(assembly);
  const std::string unit = simulation.deck().units.length;
  line("blocks", fmt::format("{} ({}){}", assembly.num_blocks(), list(quality.blocks_by_corners),
                             quality.non_convex ? fmt::format(", {} not convex", quality.non_convex) : ""));
  for (std::size_t r = 0; r < assembly.regions.size(); ++r) {
    const auto count = std::ranges::count(assembly.blocks, static_cast<int>(r), &Block::region);
    line("region",
         fmt::format("{}: {} blocks of {}", assembly.regions[r].name, count, assembly.regions[r].material));
  }
  line("area", fmt::format("{:.6g} {}², blocks {:.3g} to {:.3g}, ratio {:.3g}", quality.area, unit,
                           quality.smallest_area, quality.largest_area, quality.area_ratio()));
  line("quality", fmt::format("worst aspect {:.3g}, shortest side {:.3g} of the block's size",
                              quality.worst_aspect, quality.shortest_side));
}

void print_groups(const Simulation& simulation) {
  const auto groups = connected_groups(simulation.assembly());
  if (groups.size() == 1) return line("floating blocks", "none: all hang together");
  line("separate parts", fmt::format("{}, each held by supports of its own", groups.size()));
  for (const auto& group : groups)
    line("", fmt::format("{} blocks, the first is number {}", group.size(), group.front().value()));
}

void print_interfaces(const Simulation& simulation) {
  const Equilibrium& equilibrium = simulation.equilibrium();
  const InterfaceSet& set = equilibrium.interfaces();
  std::vector<std::size_t> points(set.names.size()), cracking(set.names.size());
  for (const InterfacePoint& point : set.points) {
    if (point.interface < 0) continue;
    const auto i = static_cast<std::size_t>(point.interface);
    ++points[i];
    if (point.law->can_crack()) ++cracking[i];
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    line("interface", fmt::format("{}: {} points{}", set.names[i], points[i],
                                  cracking[i] ? ""
                                  : points[i] ? ", bonded"
                                              : ": nothing lies on it"));
  line("interface points",
       fmt::format("{}, of which {} can crack", equilibrium.num_points(), set.num_crackable()));
  for (const std::string& notice : simulation.notices()) line("notice", notice);
}

/// How blocks deform, and where second order would do the same with fewer unknowns.
void print_kinematics(const Simulation& simulation) {
  const Body& body = simulation.body();
  const InterfaceSet& set = simulation.equilibrium().interfaces();
  if (body.num_gradients() > 0)
    return line("kinematics", fmt::format("{} of {} blocks are of second order", body.num_gradients(),
                                          body.assembly.num_blocks()));
  if (simulation.deck().moves() || body.cracks) return;
  constexpr std::size_t few = 4;  // one in so many
  if (set.num_crackable() == 0 && !set.points.empty())
    line("advice",
         "nothing cracks here: where it bends, with `kinematics: second_order` and blocks twice to four "
         "times as "
         "large the error is the same, with a tenth to a hundredth of the unknowns");
  else if (set.num_crackable() > 0 && few * set.num_crackable() < set.points.size())
    line("advice",
         "cracks keep to a few sides here: with `kinematics: second_order` and blocks twice to four times as "
         "large the error is the same, with a fifth to a tenth of the unknowns");
}

/// Of a run that ranks share.
void print_ranks(const Simulation& simulation, const PredictedMemory& least, int ranks) {
  const auto mib = [](double bytes) { return bytes / bytes_per_mib; };
  const std::vector<double> factors = factors_by_rank(simulation, ranks);
  line("rank 0",
       fmt::format("at least {:.0f} MiB: {:.0f} held now, {:.0f} its part of the factor, {:.0f} vectors",
                   mib(least.held + factors.front() + least.vectors), mib(least.held), mib(factors.front()),
                   mib(least.vectors)));
  for (std::size_t rank = 1; rank < factors.size(); ++rank)
    line(fmt::format("rank {}", rank),
         fmt::format("at least {:.0f} MiB: its part of the factor", mib(factors[rank])));
}

void print_size(const Simulation& simulation, int ranks) {
  line("unknowns", fmt::format("{}", simulation.equilibrium().num_unknowns()));
  const PredictedMemory least = predicted_memory(simulation);
  const auto mib = [](double bytes) { return bytes / bytes_per_mib; };
  line("memory",
       fmt::format("at least {:.0f} MiB: {:.0f} held now, {:.0f} the factor, {:.0f} vectors; cracks "
                   "take more",
                   mib(least.total()), mib(least.held), mib(least.factor), mib(least.vectors)));
  if (ranks > 1 && simulation.deck().has_path()) print_ranks(simulation, least, ranks);
}

/// What variables have come to.
void print_variables(DeckTree& tree, const std::vector<std::string>& overrides) {
  for (const std::string& assignment : overrides) tree.set(assignment);
  for (const auto& [name, value] : variables_of(tree))
    line("variable", fmt::format("{} = {:.10g}", name, value));
}

/// What a motion begins with, and how long its steps are at most.
void print_motion(const Simulation& simulation) {
  const MotionParameters& parameters = *simulation.deck().motion;
  const std::size_t blocks = simulation.assembly().num_blocks();
  std::size_t held = 0;
  for (const Block& block : simulation.assembly().blocks)
    held += is_held(simulation.body(), parameters, block.region);
  line("motion", fmt::format("{} of {} blocks, {}, {} at most{}", blocks - held, blocks,
                             simulation.deck().has_path() ? "from the end of the path on"
                                                          : "from the undeformed structure on",
                             parameters.time > 0 ? fmt::format("{:g} s", parameters.time) : "40 √(size/g)",
                             parameters.stops_at_rest ? " or until rest" : ""));
  line("integrator", parameters.integrator.name());
  const OpenCloseRules* rules = parameters.integrator.make()->open_close();
  const auto friction = friction_of_others(simulation.equilibrium().interfaces(), parameters);
  line("contact", fmt::format("{}, friction {}, restitution {:g}, {} pairs of their own",
                              rules ? "penalties that open and close" : parameters.contact.law.name(),
                              friction ? fmt::format("{:g}", *friction) : "of pairs",
                              parameters.contact.restitution, parameters.contact.pairs.size()));
}

void print_gauges(const Simulation& simulation) {
  for (const NamedGauge& gauge : simulation.gauges().gauges)
    line("gauge", fmt::format("{} [{}]", gauge.name, label(gauge.dimension, simulation.deck().units)));
}

void print_loading(const Simulation& simulation) {
  for (const auto& [name, reaction] : simulation.loading().reactions) line("support", name);
  const auto& stages = simulation.equilibrium().stages();
  for (std::size_t s = 0; s < stages.size(); ++s)
    line("stage", fmt::format("{}{}", stages[s].name,
                              s + 1 == stages.size() ? ", times the load factor" : ", in full first"));
  for (const Loading& stage : simulation.equilibrium().later_stages())
    line("stage", stage.name + ", times a load factor of its own, what acted before being held");
  print_gauges(simulation);
  line("control", simulation.deck().path.control.name());
}

/// What makes results that are none.
void print_warnings(const Simulation& simulation) {
  constexpr std::size_t most = 6;
  const auto tearing = tearing_warnings(simulation);
  for (std::size_t i = 0; i < std::min(most, tearing.size()); ++i) line("warning", tearing[i]);
  if (tearing.size() > most) line("warning", fmt::format("the same of {} more", tearing.size() - most));
  for (const CoarseZone& zone : coarse_zones(simulation)) line("warning", text(simulation, zone));
  for (const std::string& unlikely : unlikely_numbers(simulation)) line("warning", unlikely);
  if (const std::string corner = note_on_shallow_corners(simulation); !corner.empty())
    line("warning", corner);
}

/// The decks of a sweep are read, not meshed: there may be hundreds.
int check_sweep(const CommandLine& command) {
  const Sweep sweep = read_sweep(command.deck, command.overrides);
  fmt::print("{} is a valid sweep{}\n", command.deck.string(), sweep.title.empty() ? "" : ": " + sweep.title);
  line("cases",
       fmt::format("{}, the first: {}", sweep.cases.size(), settings_text(sweep, sweep.cases.front())));
  const std::vector<SweptKey> keys = sweep.keys();
  for (std::size_t k = 0; k < keys.size(); ++k)
    line("varied", fmt::format("{}: {} values{}", keys[k].name, keys[k].values.size(),
                               sweep.key_units[k].empty() ? "" : " [" + sweep.key_units[k] + "]"));
  return 0;
}

}  // namespace

int command_check(const CommandLine& command) {
  if (!command.picture.empty()) require_figure_name(command.picture);
  DeckSource source = read_source(command.deck);
  DeckTree tree(source.root);
  if (is_sweep(tree.root(), command.overrides)) return check_sweep(command);
  const DeckFile file = read_deck(std::move(source), command.overrides);
  Timings timings;
  const Simulation simulation(file.deck, timings);
  fmt::print("{} is valid{}\n", command.deck.string(), file.deck.title.empty() ? "" : ": " + file.deck.title);
  print_variables(tree, command.overrides);
  print_blocks(simulation);
  print_interfaces(simulation);
  print_kinematics(simulation);
  if (file.deck.has_path()) {
    print_groups(simulation);
    print_size(simulation, command.ranks);
    print_loading(simulation);
    print_warnings(simulation);
  } else {
    print_gauges(simulation);
  }
  if (file.deck.moves()) print_motion(simulation);
  if (!command.picture.empty()) {
    write_figure(command.picture, model_picture(simulation));
    line("picture", command.picture.string());
  }
  return 0;
}

}  // namespace dda
