#include "studies/dda/case/model_tables.hpp"

#include <algorithm>

#include "models/loading.hpp"

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
  std::vector<std::string> materials;
  for (const Region& region : assembly.regions) materials.push_back(region.material);
  out.push_back({"region_materials", {}, {}, std::move(materials), 1});
}

/// Forces of the dead stages and of the last one, and the stresses that are there without strain.
struct StageSums {
  Vector dead, reference;
  std::vector<Vec3> dead_stress, reference_stress;
};

void add(const StageLoads& loads, const Body& body, Vector& force, std::vector<Vec3>& stress) {
  for (std::size_t i = 0; i < loads.force.size(); ++i) force[i] += loads.force[i];
  for (std::size_t b = 0; b < loads.initial_stress.size(); ++b) {
    stress[b] += loads.initial_stress[b];
    Eigen::Map<Vec6>(force.data() + block_unknowns * b).tail<3>() +=
        body.volume(BlockId(b)) * loads.initial_stress[b];
  }
}

StageSums sums(const Body& body, const LoadProgramme& programme) {
  const std::size_t blocks = body.assembly.num_blocks(), n = block_unknowns * body.num_nodes();
  StageSums out{Vector(n), Vector(n), std::vector<Vec3>(blocks, Vec3::Zero()),
                std::vector<Vec3>(blocks, Vec3::Zero())};
  for (std::size_t s = 0; s + 1 < programme.stages.size(); ++s)
    add(programme.stages[s], body, out.dead, out.dead_stress);
  add(programme.stages.back(), body, out.reference, out.reference_stress);
  return out;
}

/// Blocks whose strain gradients are nodes behind the blocks, in that order.
void add_second_order(const Body& body, std::vector<ResultsTable>& out) {
  if (body.num_gradients() == 0) return;
  std::vector<std::int64_t> blocks;
  for (const BlockId id : body.second_order.blocks) blocks.push_back(static_cast<std::int64_t>(id.value()));
  out.push_back({"second_order/block", {}, std::move(blocks), {}, 1});
}

void add_loads(const StageSums& loads, std::size_t num_nodes, std::vector<ResultsTable>& out) {
  Vector dead, reference;
  std::vector<std::int64_t> blocks;
  for (std::size_t b = 0; b < num_nodes; ++b) {
    const Eigen::Map<const Vec6> before(loads.dead.data() + block_unknowns * b),
        now(loads.reference.data() + block_unknowns * b);
    if (before.isZero(0) && now.isZero(0)) continue;
    blocks.push_back(static_cast<std::int64_t>(b));
    append(before, dead);
    append(now, reference);
  }
  out.push_back({"load/block", {}, std::move(blocks), {}, 1});
  out.push_back({"load/dead", std::move(dead), {}, {}, block_unknowns});
  out.push_back({"load/reference", std::move(reference), {}, {}, block_unknowns});
}

void add_initial_stress(const StageSums& loads, std::vector<ResultsTable>& out) {
  Vector dead, reference;
  for (const Vec3& stress : loads.dead_stress) append(stress, dead);
  for (const Vec3& stress : loads.reference_stress) append(stress, reference);
  const auto is_zero = [](double value) { return value == 0; };
  if (std::ranges::all_of(dead, is_zero) && std::ranges::all_of(reference, is_zero)) return;
  out.push_back({"initial_stress/dead", std::move(dead), {}, {}, 3});
  out.push_back({"initial_stress/reference", std::move(reference), {}, {}, 3});
}

/// The far ends of driven springs: those of earlier stages stay.
void far_ends(const LoadProgramme& programme, std::size_t num_supports, Vector& dead, Vector& reference) {
  std::size_t spring = num_supports;
  for (std::size_t s = 0; s < programme.stages.size(); ++s)
    for (const DrivenSpring& driven : programme.stages[s].driven)
      (s + 1 < programme.stages.size() ? dead : reference)[spring++] = driven.prescribed;
}

/// Supports, and behind them what loads drive.
std::vector<Spring> all_springs(const LoadProgramme& programme, const Equilibrium& equilibrium) {
  std::vector<Spring> out = equilibrium.supports();
  out.insert(out.end(), programme.driven.begin(), programme.driven.end());
  return out;
}

void add_springs(const LoadProgramme& programme, const Equilibrium& equilibrium,
                 std::vector<ResultsTable>& out) {
  const std::vector<Spring> springs = all_springs(programme, equilibrium);
  Vector stiffness, rows, dead(springs.size()), reference(springs.size());
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
  far_ends(programme, equilibrium.supports().size(), dead, reference);
  out.push_back({"spring/stiffness", std::move(stiffness), {}, {}, 1});
  out.push_back({"spring/dead", std::move(dead), {}, {}, 1});
  out.push_back({"spring/reference", std::move(reference), {}, {}, 1});
  out.push_back({"spring/names", {}, {}, std::move(names), 1});
  out.push_back({"spring_part/spring", {}, std::move(numbers), {}, 1});
  out.push_back({"spring_part/block", {}, std::move(blocks), {}, 1});
  out.push_back({"spring_part/row", std::move(rows), {}, {}, block_unknowns});
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

/// Forces on the jumps, and what springs feel of them.
void add_forces_on_jumps(const Body& body, const LoadProgramme& programme, const Equilibrium& equilibrium,
                         std::vector<ResultsTable>& out) {
  const StageSums loads = sums(body, programme);
  const std::vector<std::int64_t> cut = cuts_of_jumps(body.cracks->cuts());
  const std::size_t first = body.assembly.num_blocks() + body.num_gradients();
  Vector dead(3 * body.cracks->cuts().size()), reference(dead.size()), rows;
  for (std::size_t jump = 0; jump < cut.size(); ++jump)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t to = 3 * static_cast<std::size_t>(cut[jump]) + i,
                        from = block_unknowns * body.node_of(JumpId{jump}).value() + i;
      dead[to] = loads.dead[from];
      reference[to] = loads.reference[from];
    }
  std::vector<std::int64_t> numbers, of_springs;
  const std::vector<Spring> springs = all_springs(programme, equilibrium);
  for (std::size_t s = 0; s < springs.size(); ++s)
    for (const auto& [node, row] : springs[s].displacement.rows) {
      if (node.value() < first) continue;
      numbers.push_back(static_cast<std::int64_t>(s));
      of_springs.push_back(cut[node.value() - first]);
      append(row.head<3>(), rows);
    }
  out.push_back({"cuts/dead", std::move(dead), {}, {}, 3});
  out.push_back({"cuts/reference", std::move(reference), {}, {}, 3});
  out.push_back({"cuts/spring_part/spring", {}, std::move(numbers), {}, 1});
  out.push_back({"cuts/spring_part/cut", {}, std::move(of_springs), {}, 1});
  out.push_back({"cuts/spring_part/row", std::move(rows), {}, {}, 3});
}

}  // namespace

std::vector<ResultsTable> model_tables(const Body& body, const ModelParameters& model,
                                       const Equilibrium& equilibrium) {
  Findings none;
  const LoadProgramme programme = make_loads(body, model, none);
  const StageSums loads = sums(body, programme);
  std::vector<ResultsTable> out;
  if (body.cracks)
    add_sides(body.assembly,
              make_interface_points(
                  {body.assembly, body.thickness, body.materials, nullptr, body.second_order}, model, none),
              out);
  else
    add_sides(body.assembly, equilibrium.interfaces(), out);
  add_second_order(body, out);
  add_loads(loads, body.assembly.num_blocks() + body.num_gradients(), out);
  add_initial_stress(loads, out);
  add_springs(programme, equilibrium, out);
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
  add_forces_on_jumps(body, make_loads(body, model, none), equilibrium, out);
  return out;
}

}  // namespace dda
