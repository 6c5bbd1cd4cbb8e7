#include "continuation/handover/handover.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "continuation/bodies/joined.hpp"
#include "continuation/handover/drawn_overlaps.hpp"
#include "continuation/handover/regions.hpp"
#include "meshing/contact/outline.hpp"
#include "models/equilibrium/loading.hpp"

namespace dda {
namespace {

class Maker {
 public:
  Maker(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters)
      : pieces_(pieces), body_(pieces.body()), end_(end), parameters_(parameters) {}

  Handover make() {
    out_.offset = offset_of_all();
    out_.scene.smallest = size_for_steps();
    set_back_ = set_back(body_, parameters_);
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) add_body(BlockId(b));
    add_rules();
    add_supports();
    add_loads();
    add_bonds();
    for (const DriveParameters& drive : parameters_.driven)
      out_.scene.drives.push_back(
          {blocks_of(drive.regions), drive.direction.normalized(), drive.displacement.make()});
    out_.velocities.assign(out_.poses.size(), Pose::Zero());
    for (const VelocityParameters& thrown : parameters_.velocities) add_velocity(thrown);
    out_.scene.around = blocks_around_vertices();
    return std::move(out_);
  }

 private:
  void add_body(BlockId id) {
    const Block& block = body_.block(id);
    const Material& material = body_.material(id);
    MovingBody out;
    const double density = material.density() * body_.thickness;
    out.block = {density * block.moments.area, density * block.moments.second, body_.volume(id),
                 material.stiffness(), initial_stress(pieces_.equilibrium(), id)};
    out.centroid = block.moments.centroid;
    out.size = std::sqrt(block.moments.area);
    out.modulus = material.modulus();
    out.is_held = is_held(body_, parameters_, block.region);
    for (const Vec2& x : core_of(block.outline, out_.offset + set_back_[id.value()]).vertices)
      out.core.push_back(x - out.centroid);
    for (const Vec2& x : block.outline.vertices) out.outline.push_back(x - out.centroid);
    const Vec6 d = pieces_.displacements(id.value(), end_.state.d.all());
    out_.poses.push_back(finite_pose(out.centroid, d));
    out_.scene.bodies.push_back(std::move(out));
  }

  /// λ in the motion.
  double load_factor() const { return parameters_.loads == KeptLoads::dead ? 0 : end_.state.load_factor; }

  Vec3 initial_stress(const Equilibrium& of, BlockId block) const {
    return of.stages().back().initial_stress(block.value(), load_factor());
  }

  void add_rules() {
    MovingScene& scene = out_.scene;
    scene.gravity = parameters_.gravity;
    scene.thickness = body_.thickness;
    scene.meeting.law = parameters_.contact.law.make();
    scene.meeting.reach = 2 * out_.offset;
    scene.meeting.stiffness = parameters_.contact.stiffness;
    scene.meeting.friction = friction();
    scene.meeting.restitution = restitution();
  }

  std::vector<std::size_t> blocks_of(const std::vector<std::string>& regions) const {
    std::vector<std::size_t> out;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b)
      if (is_named(regions, body_, body_.assembly.blocks[b].region)) out.push_back(b);
    return out;
  }

  /// As one body, whose centroid is that of its mass.
  void add_velocity(const VelocityParameters& thrown) {
    const std::vector<std::size_t> blocks = blocks_of(thrown.regions);
    double mass = 0;
    Vec2 centre = Vec2::Zero();
    for (const std::size_t b : blocks) {
      const double part = out_.scene.bodies[b].block.mass;
      mass += part;
      centre += part * centre_of(out_.poses[b]);
    }
    centre /= mass;
    for (const std::size_t b : blocks) {
      const Vec2 arm = centre_of(out_.poses[b]) - centre;
      const RigidMotion own = {thrown.velocity + thrown.spin * Vec2(-arm.y(), arm.x()), thrown.spin};
      out_.velocities[b] += rate_of(out_.poses[b], own);
    }
  }

  const std::string& material_of(BlockId block) const {
    return body_.assembly.regions[static_cast<std::size_t>(body_.block(block).region)].material;
  }

  /// What the deck says of pairs of materials.
  std::map<std::pair<std::string, std::string>, double> of_pairs(
      std::optional<double> PairParameters::*what) const {
    std::map<std::pair<std::string, std::string>, double> out;
    for (const PairParameters& pair : parameters_.contact.pairs)
      if (pair.*what) out[std::minmax(pair.between[0], pair.between[1])] = *(pair.*what);
    return out;
  }

  std::vector<std::string> materials_of_blocks() const {
    std::vector<std::string> out;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) out.push_back(material_of(BlockId(b)));
    return out;
  }

  /// Null where nothing is given back.
  std::function<double(std::size_t, std::size_t)> restitution() const {
    const auto of_materials = of_pairs(&PairParameters::restitution);
    const double otherwise = parameters_.contact.restitution;
    if (otherwise == 0 &&
        std::ranges::all_of(of_materials, [](const auto& pair) { return pair.second == 0; }))
      return nullptr;
    return [of_materials, names = materials_of_blocks(), otherwise](std::size_t a, std::size_t b) {
      const auto found = of_materials.find(std::minmax(names[a], names[b]));
      return found == of_materials.end() ? otherwise : found->second;
    };
  }

  /// tan φ of two bodies: what is left of the interface between them; of others what the deck says of their materials, or
  /// that of the interfaces between these, where they agree; else the deck's for all.
  std::function<double(std::size_t, std::size_t)> friction() const {
    std::map<std::pair<std::size_t, std::size_t>, double> of_blocks;
    std::map<std::pair<std::string, std::string>, std::set<double>> of_materials;
    for (const InterfacePoint& point : end_.equilibrium.interfaces().points) {
      const auto residual = point.law->residual_friction();
      if (!residual) continue;
      const auto [first, second] = pieces_.beside(point);
      of_blocks[std::minmax(first, second)] = *residual;
      of_materials[std::minmax(material_of(BlockId{first}), material_of(BlockId{second}))].insert(*residual);
    }
    std::map<std::pair<std::string, std::string>, double> by_materials = of_pairs(&PairParameters::friction);
    for (const auto& [pair, values] : of_materials)
      if (values.size() == 1) by_materials.emplace(pair, *values.begin());
    const double otherwise = friction_of_others(end_.equilibrium.interfaces(), parameters_).value_or(0);
    return [of_blocks, by_materials, names = materials_of_blocks(), otherwise](std::size_t a, std::size_t b) {
      if (const auto found = of_blocks.find(std::minmax(a, b)); found != of_blocks.end())
        return found->second;
      const auto found = by_materials.find(std::minmax(names[a], names[b]));
      return found == by_materials.end() ? otherwise : found->second;
    };
  }

  /// The same spring on poses: l · d becomes row · (y − y₀).
  MotionSpring spring_of(const Spring& spring) const {
    MotionSpring out{{}, 0, spring.stiffness};
    for (const auto& [id, row] : spring.displacement.rows) {
      const Vec6 finite = finite_row(row);
      out.rows.emplace_back(id.value(), finite);
      out.length += finite.dot(out_.scene.bodies[id.value()].undeformed());
    }
    return out;
  }

  /// Whether it holds nothing but what is held or driven without it, wherever that goes.
  bool is_needless(const Spring& spring) const {
    return std::ranges::all_of(spring.displacement.rows,
                               [&](const auto& row) { return out_.scene.bodies[row.first.value()].is_held; });
  }

  void add_supports() {
    if (parameters_.keeps_supports)
      for (const Spring& spring : pieces_.equilibrium().supports())
        if (!is_needless(spring)) out_.scene.springs.push_back(spring_of(spring));
    for (std::size_t i = 0; i < pieces_.equilibrium().driven_springs().size(); ++i)
      out_.scene.springs.push_back(driven_spring(i));
  }

  /// What is driven stays where the path has driven it, whatever becomes of forces.
  MotionSpring driven_spring(std::size_t i) const {
    MotionSpring out = spring_of(pieces_.equilibrium().driven_springs()[i]);
    const Functional& force = pieces_.equilibrium().stages().back().driven[i].force;
    out.length += (force.constant + end_.state.load_factor * force.per_load_factor) / out.stiffness;
    return out;
  }

  /// Dead forces; what initial stress does among them is in blocks and joints, with which it turns.
  void add_loads() {
    const Loading& loading = pieces_.equilibrium().stages().back();
    const Forces dead = stress_forces(loading.dead_stress),
                 reference = stress_forces(loading.reference_stress);
    out_.is_pushed = end_.has_fallen && parameters_.push > 0 && parameters_.loads == KeptLoads::all;
    const double factor = load_factor() * (out_.is_pushed ? 1 + parameters_.push : 1);
    const Forces left = left_of_supports(factor);
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
      const Vec6 force = part(loading.dead_work, b) - part(dead, b) - part(left, b) +
                         factor * (part(loading.reference_work, b) - part(reference, b));
      out_.scene.forces.push_back(finite_row(force));
    }
  }

  using Forces = std::vector<double>;

  /// Of supports that the last stage takes away; in motion that is let go.
  Forces left_of_supports(double factor) const {
    const Equilibrium& equilibrium = pieces_.equilibrium();
    const StageHistory& history = equilibrium.history();
    Forces out(block_unknowns * body_.assembly.num_blocks());
    for (std::size_t i = 0; i < history.borne.size(); ++i)
      if (const auto& [spring, stage] = equilibrium.removed_springs()[i];
          stage == equilibrium.present_stage())
        equilibrium.all_supports()[spring].displacement.add_gradient((1 - factor) * history.borne[i], out);
    return out;
  }

  static Vec6 part(const Forces& all, std::size_t block) {
    return all.empty() ? Vec6(Vec6::Zero())
                       : Vec6(Eigen::Map<const Vec6>(all.data() + block_unknowns * block));
  }

  /// The forces that a stress without strain is on the path; none where there is none.
  Forces stress_forces(const std::vector<Vec3>& stress) const {
    if (stress.empty()) return {};
    Forces out = stress_offset(body_, pieces_.equilibrium().interfaces(), stress).force;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b)
      Eigen::Map<Vec6>(out.data() + block_unknowns * b).tail<3>() -= body_.volume(BlockId(b)) * stress[b];
    return out;
  }

  /// Of the points of the path; where blocks of second order are of first from here on, joints that cannot crack are those of
  /// first order, since those of second hold such blocks more firmly than they can follow.
  void add_bonds() {
    const Equilibrium& equilibrium = end_.equilibrium;
    const std::size_t num = pieces_.are_lowered() ? equilibrium.num_active() : equilibrium.num_points();
    for (std::size_t p = 0; p < num; ++p) {
      Bond bond = bond_of(equilibrium.point(p));
      if (p < equilibrium.num_active()) bond.history = end_.history[p];
      bond.multiplier += multiplier_of(equilibrium.point(p), p);
      add(bond);
    }
    const Equilibrium& lowered = pieces_.equilibrium();
    if (pieces_.are_lowered())
      for (std::size_t p = lowered.num_active(); p < lowered.num_points(); ++p)
        add(bond_of(lowered.point(p)));
  }

  void add(const Bond& bond) {
    if (out_.scene.bodies[bond.first].is_held && out_.scene.bodies[bond.second].is_held) return;
    (bond.is_end ? out_.touching : out_.bonds).push_back(bond);
  }

  /// As if nothing had happened to it.
  Bond bond_of(const InterfacePoint& point) const {
    Bond out;
    std::tie(out.first, out.second) = pieces_.beside(point);
    out.at_first = point.x - body_.block(BlockId{out.first}).moments.centroid;
    out.at_second = point.x - body_.block(BlockId{out.second}).moments.centroid;
    out.normal = point.normal;
    out.stress_first = point.rows.first_stress.rightCols<3>();
    out.stress_second = point.rows.second_stress.rightCols<3>();
    out.weight = point.weight;
    out.stiffness = point.stiffness;
    out.law = point.law;
    out.interface = point.interface;
    out.initial_stress = initial_traction(point);
    if (pieces_.is_cut(point.first) || pieces_.is_cut(point.second)) fix_stress(point, out);
    out.is_end = point.is_separate();
    return out;
  }

  /// {σ0}n of a consistent joint: the weights of {σ}n are those of its rows, A = w n C.
  Vec2 initial_traction(const InterfacePoint& point) const {
    const auto of = [&](const Mat26& rows, BlockId block) -> Vec2 {
      return rows.rightCols<3>() * pieces_.whole().material(block).stiffness().inverse() *
             initial_stress(end_.equilibrium, block);
    };
    return of(point.rows.first_stress, point.first) + of(point.rows.second_stress, point.second);
  }

  /// A part may be too small for the energy that a consistent joint takes off: what its stress adds to the opening stays
  /// as it is now.
  void fix_stress(const InterfacePoint& point, Bond& bond) const {
    const auto strain = [&](BlockId block) {
      return Eigen::Map<const Vec3>(end_.state.d.data() + block_unknowns * block.value() + 3);
    };
    const Vec2 stress = bond.stress_first * strain(point.first) + bond.stress_second * strain(point.second) +
                        bond.initial_stress;
    bond.multiplier += stress.cwiseQuotient(bond.trial_stiffness());
    bond.initial_stress.setZero();
    bond.stress_first.setZero();
    bond.stress_second.setZero();
  }

  /// m of a joint with multipliers, which stays as it is.
  Vec2 multiplier_of(const InterfacePoint& point, std::size_t p) const {
    const State& at = end_.state;
    if (point.multiplier == Multiplier::unknown)
      return point.multiplier_rows() *
             Eigen::Map<const Vec6>(at.d.data() + block_unknowns * point.node.value());
    if (point.multiplier == Multiplier::iterated && p < at.multipliers.size()) return at.multipliers[p];
    return Vec2::Zero();
  }

  /// Blocks that have a corner at the same place, or a corner on another one's side.
  std::vector<std::vector<std::uint32_t>> blocks_around_vertices() const {
    const double tolerance = 1e-6 * smallest_size(body_.assembly);
    std::map<std::pair<long long, long long>, std::vector<std::uint32_t>> at;
    const auto add = [&](const Vec2& x, std::size_t b) {
      auto& blocks = at[{std::llround(x.x() / tolerance / 10), std::llround(x.y() / tolerance / 10)}];
      if (std::ranges::find(blocks, b) == blocks.end()) blocks.push_back(static_cast<std::uint32_t>(b));
    };
    for (const Side& side : body_.assembly.sides)
      for (const Vec2& x : {side.start, side.end}) {
        add(x, side.first.value());
        add(x, side.second.value());
      }
    std::vector<std::vector<std::uint32_t>> out;
    for (auto& [place, blocks] : at) out.push_back(std::move(blocks));
    return out;
  }

  /// Of the smallest block that moves, cracks or not.
  double size_for_steps() const {
    double out = std::numeric_limits<double>::infinity();
    for (const Block& block : pieces_.whole().assembly.blocks)
      if (!is_held(pieces_.whole(), parameters_, block.region))
        out = std::min(out, std::sqrt(block.moments.area));
    return out;
  }

  /// That of the deck, or so much less that the parts of cut blocks have cores.
  double offset_of_all() const {
    constexpr double least = 1e-6;
    double out = offset_of(pieces_.whole(), parameters_);
    for (const double smallest = least * smallest_size(pieces_.whole().assembly); pieces_.are_cut();
         out /= 2) {
      const auto narrow = too_narrow(body_.assembly, out);
      if (!narrow) break;
      if (out < smallest)
        throw InputError(parameters_.where,
                         "motion: a crack has left a part of a block that is too narrow, " + *narrow);
    }
    return out;
  }

  const Pieces& pieces_;
  const Body& body_;
  const PathEnd& end_;
  const MotionParameters& parameters_;
  std::vector<double> set_back_;  ///< of cores, by block [L]
  Handover out_;
};

}  // namespace

Handover hand_over(const Pieces& pieces, const PathEnd& end, const MotionParameters& parameters) {
  return Maker(pieces, end, parameters).make();
}

void drop_spent(Handover& from, const std::vector<MeetingSearch::Pair>& kept) {
  const std::vector<MeetingSearch::Pair> joined = joined_by(from.bonds, from.scene.around);
  std::erase_if(from.bonds, [&](const Bond& bond) {
    return bond.is_spent() && !std::ranges::binary_search(joined, pair_of(bond)) &&
           !std::ranges::binary_search(kept, pair_of(bond));
  });
  std::ranges::copy_if(from.touching, std::back_inserter(from.bonds),
                       [&](const Bond& bond) { return std::ranges::binary_search(kept, pair_of(bond)); });
}

}  // namespace dda
