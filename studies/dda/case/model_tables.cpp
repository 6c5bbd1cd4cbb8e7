#include "studies/dda/case/model_tables.hpp"

#include <algorithm>

#include "models/loading.hpp"

namespace dda {
namespace {

using Vector = std::vector<double>;

void append(const auto& v, Vector& to) { to.insert(to.end(), v.begin(), v.end()); }

void add_sides(const Assembly& assembly, const Equilibrium& equilibrium, std::vector<ResultsTable>& out) {
  Vector stiffness(assembly.sides.size(), 0.0), ends;
  std::vector<std::int64_t> interface(assembly.sides.size(), -1), blocks;
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    if (point.cut) continue;
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
  out.push_back({"interface_names", {}, {}, equilibrium.interfaces().names, 1});
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
  const std::size_t n = body.assembly.num_blocks();
  StageSums out{Vector(block_unknowns * n), Vector(block_unknowns * n), std::vector<Vec3>(n, Vec3::Zero()),
                std::vector<Vec3>(n, Vec3::Zero())};
  for (std::size_t s = 0; s + 1 < programme.stages.size(); ++s)
    add(programme.stages[s], body, out.dead, out.dead_stress);
  add(programme.stages.back(), body, out.reference, out.reference_stress);
  return out;
}

void add_loads(const StageSums& loads, std::vector<ResultsTable>& out) {
  Vector dead, reference;
  std::vector<std::int64_t> blocks;
  for (std::size_t b = 0; block_unknowns * b < loads.dead.size(); ++b) {
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

void add_springs(const LoadProgramme& programme, const Equilibrium& equilibrium,
                 std::vector<ResultsTable>& out) {
  std::vector<Spring> springs = equilibrium.supports();
  const std::size_t num_supports = springs.size();
  springs.insert(springs.end(), programme.driven.begin(), programme.driven.end());
  Vector stiffness, rows, dead(springs.size()), reference(springs.size());
  std::vector<std::int64_t> numbers, blocks;
  std::vector<std::string> names;
  for (std::size_t s = 0; s < springs.size(); ++s) {
    stiffness.push_back(springs[s].stiffness);
    names.push_back(springs[s].reaction);
    for (const auto& [block, row] : springs[s].displacement.rows) {
      numbers.push_back(static_cast<std::int64_t>(s));
      blocks.push_back(static_cast<std::int64_t>(block.value()));
      append(row, rows);
    }
  }
  far_ends(programme, num_supports, dead, reference);
  out.push_back({"spring/stiffness", std::move(stiffness), {}, {}, 1});
  out.push_back({"spring/dead", std::move(dead), {}, {}, 1});
  out.push_back({"spring/reference", std::move(reference), {}, {}, 1});
  out.push_back({"spring/names", {}, {}, std::move(names), 1});
  out.push_back({"spring_part/spring", {}, std::move(numbers), {}, 1});
  out.push_back({"spring_part/block", {}, std::move(blocks), {}, 1});
  out.push_back({"spring_part/row", std::move(rows), {}, {}, block_unknowns});
}

}  // namespace

std::vector<ResultsTable> model_tables(const Body& body, const ModelParameters& model,
                                       const Equilibrium& equilibrium) {
  Findings none;
  const LoadProgramme programme = make_loads(body, model, none);
  const StageSums loads = sums(body, programme);
  std::vector<ResultsTable> out;
  add_sides(body.assembly, equilibrium, out);
  add_loads(loads, out);
  add_initial_stress(loads, out);
  add_springs(programme, equilibrium, out);
  return out;
}

}  // namespace dda
