#include "studies/dda/case/model_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "models/equilibrium/loading.hpp"
#include "models/load/eigenstress.hpp"

namespace dda {
namespace {

using Vector = std::vector<double>;

void append(const auto& v, Vector& to) { to.insert(to.end(), v.begin(), v.end()); }

/// As they are without cuts: which of them cuts divide or open changes from step to step.
void add_sides(const Assembly& assembly, const InterfaceSet& interfaces, std::vector<ResultsTable>& out) {
  Vector stiffness(assembly.sides.size(), 0.0), ends;
  std::vector<std::int64_t> interface(assembly.sides.size(), -1), blocks;
  for (const InterfacePoint& point : interfaces.points) {
    stiffness[point.side] = point.stiffness;
    interface[point.side] = point.interface;
  }
  for (const Side& side : assembly.sides) {
    append(side.start, ends);
    append(side.end, ends);
    blocks.push_back(static_cast<std::int64_t>(side.first.value()));
    blocks.push_back(static_cast<std::int64_t>(side.second.value()));
  }
  out.push_back({"side/blocks", {}, std::move(blocks), {}, 2});
  out.push_back({"side/ends", std::move(ends), {}, {}, 4});
  out.push_back({"side/stiffness", std::move(stiffness), {}, {}, 1});
  out.push_back({"side/interface", {}, std::move(interface), {}, 1});
  out.push_back({"interface_names", {}, {}, interfaces.names, 1});
  out.push_back(region_materials(assembly));
}

/// Forces of a stage, or of several, and the stress that is there without strain.
struct StageForces {
  std::string name;  ///< of its tables
  Vector force;
  std::vector<Vec3> stress;  ///< as StageLoads has it
};
/// The dead ones as one, and behind it each that is followed.
using StageSums = std::vector<StageForces>;

/// Names of the tables of the dead stages and of each that is followed.
std::vector<std::string> names_of(const ModelParameters& model) {
  std::vector<std::string> out{"dead", "reference"};
  const std::vector<std::size_t> stages = model.followed_stages();
  for (std::size_t i = 1; i < stages.size(); ++i) out.push_back(fmt::format("reference_{}", stages[i] + 1));
  return out;
}

/// Place among these names of a stage with loads.
std::size_t place_of(std::size_t stage, const ModelParameters& model) {
  const std::size_t num_dead = model.num_dead_stages();
  return stage < num_dead ? 0 : 1 + stage - num_dead;
}

void add(const StageLoads& loads, const Body& body, StageForces& to) {
  for (std::size_t i = 0; i < loads.force.size(); ++i) to.force[i] += loads.force[i];
  if (loads.initial_stress.empty()) return;
  for (std::size_t i = 0; i < loads.initial_stress.size(); ++i) to.stress[i] += loads.initial_stress[i];
  for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b)
    for (const auto& [node, force] : forces_of_stress(body, BlockId(b), loads.initial_stress))
      Eigen::Map<Vec6>(to.force.data() + block_unknowns * node.value()) -= force;
}

StageSums sums(const Body& body, const ModelParameters& model, const LoadProgramme& programme) {
  const std::size_t places = body.assembly.num_blocks() + 2 * body.num_gradients(),
                    n = block_unknowns * body.num_nodes();
  StageSums out;
  for (const std::string& name : names_of(model))
    out.push_back({name, Vector(n), std::vector<Vec3>(places, Vec3::Zero())});
  for (std::size_t s = 0; s < programme.stages.size(); ++s)
    add(programme.stages[s], body, out[place_of(s, model)]);
  return out;
}

void add_followed_stages(const ModelParameters& model, std::vector<ResultsTable>& out) {
  std::vector<std::int64_t> numbers;
  for (const std::size_t stage : model.followed_stages())
    numbers.push_back(static_cast<std::int64_t>(stage) + 1);
  if (numbers.size() > 1) out.push_back({"followed_stages", {}, std::move(numbers), {}, 1});
}

/// Blocks whose strain gradients are nodes behind the blocks, in that order.
void add_second_order(const Body& body, std::vector<ResultsTable>& out) {
  if (body.num_gradients() == 0) return;
  std::vector<std::int64_t> blocks;
  for (const BlockId id : body.second_order.blocks) blocks.push_back(static_cast<std::int64_t>(id.value()));
  out.push_back({"second_order/block", {}, std::move(blocks), {}, 1});
}

void add_loads(const StageSums& loads, std::size_t num_nodes, std::vector<ResultsTable>& out) {
  std::vector<Vector> rows(loads.size());
  std::vector<std::int64_t> blocks;
  const auto part = [&](std::size_t stage, std::size_t node) {
    return Eigen::Map<const Vec6>(loads[stage].force.data() + block_unknowns * node);
  };
  for (std::size_t b = 0; b < num_nodes; ++b) {
    bool is_loaded = false;
    for (std::size_t s = 0; s < loads.size(); ++s) is_loaded = is_loaded || !part(s, b).isZero(0);
    if (!is_loaded) continue;
    blocks.push_back(static_cast<std::int64_t>(b));
    for (std::size_t s = 0; s < loads.size(); ++s) append(part(s, b), rows[s]);
  }
  out.push_back({"load/block", {}, std::move(blocks), {}, 1});
  for (std::size_t s = 0; s < loads.size(); ++s)
    out.push_back({"load/" + loads[s].name, std::move(rows[s]), {}, {}, block_unknowns});
}

void add_initial_stress(const StageSums& loads, std::size_t num_blocks, std::vector<ResultsTable>& out) {
  const auto is_none = [](const StageForces& stage) {
    return std::ranges::all_of(stage.stress, [](const Vec3& stress) { return stress.isZero(0); });
  };
  if (std::ranges::all_of(loads, is_none)) return;
  for (const StageForces& stage : loads) {
    Vector means, slopes;
    for (std::size_t i = 0; i < stage.stress.size(); ++i)
      append(stage.stress[i], i < num_blocks ? means : slopes);
    out.push_back({"initial_stress/" + stage.name, std::move(means), {}, {}, 3});
    if (!slopes.empty()) out.push_back({"initial_stress_slopes/" + stage.name, std::move(slopes), {}, {}, 6});
  }
}

/// The far ends of driven springs by stage: those of earlier stages stay.
std::vector<Vector> far_ends(const LoadProgramme& programme, const ModelParameters& model,
                             std::size_t num_supports) {
  std::vector<Vector> out(names_of(model).size(), Vector(num_supports + programme.driven.size()));
  for (std::size_t s = 0; s < programme.stages.size(); ++s)
    for (const DrivenSpring& driven : programme.stages[s].driven)
      out[place_of(s, model)][num_supports + driven.spring] += driven.sense * driven.prescribed;
  return out;
}

/// All supports, and behind them what loads drive.
std::vector<Spring> all_springs(const LoadProgramme& programme, const Equilibrium& equilibrium) {
  std::vector<Spring> out = equilibrium.all_supports();
  out.insert(out.end(), programme.driven.begin(), programme.driven.end());
  return out;
}

/// Which springs come or go, and in which of the stages that are followed.
void add_changing_springs(const std::string& name, const std::vector<ChangingSpring>& springs,
                          const ModelParameters& model, std::vector<ResultsTable>& out) {
  std::vector<std::int64_t> rows;
  for (const auto& [spring, stage] : springs)
    rows.insert(rows.end(), {static_cast<std::int64_t>(spring),
                             static_cast<std::int64_t>(stage - model.num_dead_stages())});
  if (!rows.empty()) out.push_back({"spring/" + name, {}, std::move(rows), {}, 2});
}

void add_springs(const LoadProgramme& programme, const ModelParameters& model, const Equilibrium& equilibrium,
                 std::vector<ResultsTable>& out) {
  const std::vector<Spring> springs = all_springs(programme, equilibrium);
  Vector stiffness, rows;
  std::vector<std::int64_t> numbers, blocks;
  std::vector<std::string> names;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    stiffness.push_back(springs[s].stiffness);
    names.push_back(springs[s].reaction);
    for (const auto& [block, row] : springs[s].displacement.rows) {
      if (block.value() >= equilibrium.num_block_nodes()) continue;  // jumps come and go
      numbers.push_back(static_cast<std::int64_t>(s));
      blocks.push_back(static_cast<std::int64_t>(block.value()));
      append(row, rows);
    }
  }
  std::vector<Vector> ends = far_ends(programme, model, equilibrium.all_supports().size());
  const std::vector<std::string> stages = names_of(model);
  out.push_back({"spring/stiffness", std::move(stiffness), {}, {}, 1});
  for (std::size_t s = 0; s < stages.size(); ++s)
    out.push_back({"spring/" + stages[s], std::move(ends[s]), {}, {}, 1});
  out.push_back({"spring/names", {}, {}, std::move(names), 1});
  out.push_back({"spring_part/spring", {}, std::move(numbers), {}, 1});
  out.push_back({"spring_part/block", {}, std::move(blocks), {}, 1});
  out.push_back({"spring_part/row", std::move(rows), {}, {}, block_unknowns});
  add_changing_springs("added", equilibrium.added_springs(), model, out);
  add_changing_springs("removed", equilibrium.removed_springs(), model, out);
}

/// Number of the cut across which each jump is.
std::vector<std::int64_t> cuts_of_jumps(const std::vector<Cut>& cuts) {
  std::vector<std::int64_t> out;
  for (std::size_t c = 0; c < cuts.size(); ++c)
    if (!cuts[c].side) out.push_back(static_cast<std::int64_t>(c));
  return out;
}

void add_cuts(const std::vector<Cut>& cuts, const Equilibrium& equilibrium, std::vector<ResultsTable>& out) {
  Vector ends, stiffness(cuts.size());
  std::vector<std::int64_t> block, side, crack, provisional, interface(cuts.size());
  for (const Cut& cut : cuts) {
    append(cut.start, ends);
    append(cut.end, ends);
    block.push_back(static_cast<std::int64_t>(cut.block.value()));
    side.push_back(cut.side ? static_cast<std::int64_t>(*cut.side) : -1);
    crack.push_back(cut.crack);
    provisional.push_back(cut.is_provisional ? 1 : 0);
  }
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    if (!point.cut) continue;
    stiffness[*point.cut] = point.stiffness;
    interface[*point.cut] = point.interface;
  }
  out.push_back({"cuts/ends", std::move(ends), {}, {}, 4});
  out.push_back({"cuts/stiffness", std::move(stiffness), {}, {}, 1});
  for (auto& [name, values] : {std::pair{"block", &block},
                               {"side", &side},
                               {"crack", &crack},
                               {"is_provisional", &provisional},
                               {"interface", &interface}})
    out.push_back({std::string("cuts/") + name, {}, std::move(*values), {}, 1});
}

/// Which cut each piece of a crack belongs to.
void add_pieces(const std::vector<Cut>& cuts, const Equilibrium& equilibrium,
                std::vector<ResultsTable>& out) {
  std::vector<std::int64_t> cut, crack, provisional;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
    const auto& of = equilibrium.point(p).cut;
    if (!of) continue;
    cut.push_back(static_cast<std::int64_t>(*of));
    crack.push_back(cuts[*of].crack);
    provisional.push_back(cuts[*of].is_provisional ? 1 : 0);
  }
  out.push_back({"cracks/cut", {}, std::move(cut), {}, 1});
  out.push_back({"cracks/crack", {}, std::move(crack), {}, 1});
  out.push_back({"cracks/is_provisional", {}, std::move(provisional), {}, 1});
}

/// Across which cuts each part of a block jumps.
void add_moves(const CrackGeometry& cracks, std::vector<ResultsTable>& out) {
  const std::vector<std::int64_t> cut = cuts_of_jumps(cracks.cuts());
  std::vector<std::int64_t> moves;
  std::int64_t number = 0;
  for (std::size_t b = 0; b < cracks.assembly().num_blocks(); ++b)
    for (const Part& part : cracks.parts(BlockId(b))) {
      for (const JumpId jump : part.jumps) moves.insert(moves.end(), {number, cut[jump.value()]});
      ++number;
    }
  if (number > 0) out.push_back({"parts/moves", {}, std::move(moves), {}, 2});
}

void add_forces_on_jumps(const Body& body, const StageSums& loads, std::vector<ResultsTable>& out) {
  const std::vector<std::int64_t> cut = cuts_of_jumps(body.cracks->cuts());
  for (const StageForces& stage : loads) {
    Vector forces(3 * body.cracks->cuts().size());
    for (std::size_t jump = 0; jump < cut.size(); ++jump)
      for (std::size_t i = 0; i < 3; ++i)
        forces[3 * static_cast<std::size_t>(cut[jump]) + i] =
            stage.force[block_unknowns * body.node_of(JumpId{jump}).value() + i];
    out.push_back({"cuts/" + stage.name, std::move(forces), {}, {}, 3});
  }
}

/// What springs feel of jumps.
void add_springs_on_jumps(const Body& body, const LoadProgramme& programme, const Equilibrium& equilibrium,
                          std::vector<ResultsTable>& out) {
  const std::vector<std::int64_t> cut = cuts_of_jumps(body.cracks->cuts());
  const std::size_t first = body.assembly.num_blocks() + body.num_gradients();
  Vector rows;
  std::vector<std::int64_t> numbers, of_springs;
  const std::vector<Spring> springs = all_springs(programme, equilibrium);
  for (std::size_t s = 0; s < springs.size(); ++s)
    for (const auto& [node, row] : springs[s].displacement.rows) {
      if (node.value() < first) continue;
      numbers.push_back(static_cast<std::int64_t>(s));
      of_springs.push_back(cut[node.value() - first]);
      append(row.head<3>(), rows);
    }
  out.push_back({"cuts/spring_part/spring", {}, std::move(numbers), {}, 1});
  out.push_back({"cuts/spring_part/cut", {}, std::move(of_springs), {}, 1});
  out.push_back({"cuts/spring_part/row", std::move(rows), {}, {}, 3});
}

}  // namespace

ResultsTable region_materials(const Assembly& assembly) {
  std::vector<std::string> materials;
  for (const Region& region : assembly.regions) materials.push_back(region.material);
  return {region_materials_table, {}, {}, std::move(materials), 1};
}

std::vector<ResultsTable> model_tables(const Body& body, const ModelParameters& model,
                                       const Equilibrium& equilibrium) {
  Findings none;
  const LoadProgramme programme = make_loads(body, model, none);
  const StageSums loads = sums(body, model, programme);
  std::vector<ResultsTable> out;
  if (body.cracks)
    add_sides(body.assembly,
              make_interface_points(
                  {body.assembly, body.thickness, body.materials, nullptr, body.second_order}, model, none),
              out);
  else
    add_sides(body.assembly, equilibrium.interfaces(), out);
  add_second_order(body, out);
  add_followed_stages(model, out);
  add_loads(loads, body.assembly.num_blocks() + body.num_gradients(), out);
  add_initial_stress(loads, body.assembly.num_blocks(), out);
  add_springs(programme, model, equilibrium, out);
  return out;
}

std::vector<ResultsTable> cut_tables(const Body& body, const ModelParameters& model,
                                     const Equilibrium& equilibrium) {
  Findings none;
  std::vector<ResultsTable> out;
  const std::vector<Cut>& cuts = body.cracks->cuts();
  add_cuts(cuts, equilibrium, out);
  add_pieces(cuts, equilibrium, out);
  add_moves(*body.cracks, out);
  const LoadProgramme programme = make_loads(body, model, none);
  add_forces_on_jumps(body, sums(body, model, programme), out);
  add_springs_on_jumps(body, programme, equilibrium, out);
  return out;
}

}  // namespace dda
