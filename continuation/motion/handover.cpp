#include "continuation/motion/handover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "framework/base/suggestion.hpp"
#include "meshing/contact/outline.hpp"

namespace dda {
namespace {

double smallest_size(const Assembly& assembly) {
  double out = std::numeric_limits<double>::infinity();
  for (const Block& block : assembly.blocks) out = std::min(out, std::sqrt(block.moments.area));
  return out;
}

double offset_of(const Body& body, const MotionParameters& parameters) {
  return parameters.contact.offset * smallest_size(body.assembly);
}

bool is_held(const Body& body, const MotionParameters& parameters, int region) {
  const std::string& name = body.assembly.regions[static_cast<std::size_t>(region)].name;
  return std::ranges::find(parameters.held, name) != parameters.held.end();
}

class Maker {
 public:
  Maker(const Body& body, const System& system, const MotionParameters& parameters)
      : body_(body),
        system_(system),
        equilibrium_(system.equilibrium()),
        parameters_(parameters),
        offset_(offset_of(body, parameters)) {}

  Handover make(const State& at, bool has_fallen) {
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) add_body(BlockId(b), at);
    add_rules();
    add_supports();
    add_loads(at, has_fallen);
    add_bonds(at);
    out_.scene.around = blocks_around_vertices();
    return std::move(out_);
  }

 private:
  void add_body(BlockId id, const State& at) {
    const Block& block = body_.block(id);
    const Material& material = body_.material(id);
    MovingBody out;
    const double density = material.density() * body_.thickness;
    out.block = {density * block.moments.area, density * block.moments.second, body_.volume(id),
                 material.stiffness()};
    out.centroid = block.moments.centroid;
    out.size = std::sqrt(block.moments.area);
    out.modulus = material.modulus();
    out.is_held = is_held(body_, parameters_, block.region);
    for (const Vec2& x : core_of(block.outline, offset_).vertices) out.core.push_back(x - out.centroid);
    const Vec6 d = Eigen::Map<const Vec6>(at.d.data() + block_unknowns * id.value());
    out_.poses.push_back(finite_pose(out.centroid, d));
    out_.scene.bodies.push_back(std::move(out));
  }

  void add_rules() {
    MovingScene& scene = out_.scene;
    scene.gravity = parameters_.gravity;
    scene.thickness = body_.thickness;
    scene.meeting.law = parameters_.contact.law.make();
    scene.meeting.reach = 2 * offset_;
    scene.meeting.stiffness = parameters_.contact.stiffness;
    scene.meeting.friction = friction();
  }

  const std::string& material_of(BlockId block) const {
    return body_.assembly.regions[static_cast<std::size_t>(body_.block(block).region)].material;
  }

  /// tan φ of two bodies: what is left of the interface between them; of others that of the interfaces between their
  /// materials, where these agree; else the deck's.
  std::function<double(std::size_t, std::size_t)> friction() const {
    std::map<std::pair<std::size_t, std::size_t>, double> of_blocks;
    std::map<std::pair<std::string, std::string>, std::set<double>> of_materials;
    for (const InterfacePoint& point : equilibrium_.interfaces().points) {
      const auto residual = point.law->residual_friction();
      if (!residual) continue;
      of_blocks[std::minmax(point.first.value(), point.second.value())] = *residual;
      of_materials[std::minmax(material_of(point.first), material_of(point.second))].insert(*residual);
    }
    std::vector<std::string> names;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) names.push_back(material_of(BlockId(b)));
    return [of_blocks, of_materials, names, otherwise = parameters_.contact.friction](std::size_t a,
                                                                                      std::size_t b) {
      if (const auto found = of_blocks.find(std::minmax(a, b)); found != of_blocks.end())
        return found->second;
      const auto found = of_materials.find(std::minmax(names[a], names[b]));
      return found != of_materials.end() && found->second.size() == 1 ? *found->second.begin() : otherwise;
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

  void add_supports() {
    if (parameters_.keeps_supports)
      for (const Spring& spring : equilibrium_.supports()) out_.scene.springs.push_back(spring_of(spring));
    for (const Spring& spring : equilibrium_.driven_springs())
      out_.scene.springs.push_back(spring_of(spring));
  }

  void add_loads(const State& at, bool has_fallen) {
    const Loading& loading = system_.loading();
    out_.is_pushed = has_fallen && parameters_.push > 0 && parameters_.loads == KeptLoads::all;
    const double factor = parameters_.loads == KeptLoads::dead ? 0
                          : out_.is_pushed                     ? at.load_factor * (1 + parameters_.push)
                                                               : at.load_factor;
    for (std::size_t b = 0; b < body_.assembly.num_blocks(); ++b) {
      const Vec6 force = Eigen::Map<const Vec6>(loading.dead.data() + block_unknowns * b) +
                         factor * Eigen::Map<const Vec6>(loading.reference.data() + block_unknowns * b);
      out_.scene.forces.push_back(finite_row(force));
    }
  }

  void add_bonds(const State& at) {
    for (std::size_t p = 0; p < equilibrium_.num_points(); ++p) {
      const InterfacePoint& point = equilibrium_.point(p);
      const bool is_active = p < equilibrium_.num_active();
      const History history = is_active ? system_.history()[p] : History{};
      if (point.is_separate() || (point.law->can_crack() && point.law->is_broken(history, point.stiffness)))
        continue;
      Bond bond;
      bond.first = point.first.value();
      bond.second = point.second.value();
      bond.at_first = point.x - body_.block(point.first).moments.centroid;
      bond.at_second = point.x - body_.block(point.second).moments.centroid;
      bond.normal = point.normal;
      bond.stress_first = point.rows.first_stress.rightCols<3>();
      bond.stress_second = point.rows.second_stress.rightCols<3>();
      bond.weight = point.weight;
      bond.stiffness = point.stiffness;
      bond.law = point.law;
      bond.history = history;
      bond.multiplier = multiplier_of(point, p, at);
      out_.bonds.push_back(bond);
    }
  }

  /// m of a joint with multipliers, which stays as it is.
  Vec2 multiplier_of(const InterfacePoint& point, std::size_t p, const State& at) const {
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

  const Body& body_;
  const System& system_;
  const Equilibrium& equilibrium_;
  const MotionParameters& parameters_;
  const double offset_;
  Handover out_;
};

}  // namespace

void require_handover(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters) {
  const Position& where = parameters.where;
  const Loading& loading = equilibrium.stages().back();
  Findings findings;
  if (body.cracks) findings.add(where, "motion: cracks through blocks cannot be handed over");
  if (!loading.dead_stress.empty() || !loading.reference_stress.empty())
    findings.add(where, "motion: initial stress cannot be handed over");
  if (parameters.loads == KeptLoads::dead && !equilibrium.driven_springs().empty())
    findings.add(where, "motion.loads: what is driven stays where it is, `keep`");
  std::vector<std::string> names;
  for (const Region& region : body.assembly.regions) names.push_back(region.name);
  for (const std::string& name : parameters.held)
    if (std::ranges::find(names, name) == names.end())
      findings.add(where, "motion.held: there is no region '" + name + "'" + suggest(name, names));
  std::set<std::string> without;
  if (std::ranges::all_of(body.assembly.blocks,
                          [&](const Block& block) { return is_held(body, parameters, block.region); }))
    findings.add(where, "motion.held: nothing is left that could move");
  for (std::size_t r = 0; r < names.size(); ++r)
    if (!is_held(body, parameters, static_cast<int>(r)) && body.materials[r]->density() <= 0)
      without.insert(body.assembly.regions[r].material);
  for (const std::string& material : without)
    findings.add(where, "motion: material '" + material + "' needs a `density`");
  const double offset = offset_of(body, parameters);
  for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b) {
    const Block& block = body.assembly.blocks[b];
    try {
      core_of(block.outline, offset);
    } catch (const std::domain_error& error) {
      const Vec2& at = block.moments.centroid;
      findings.add(
          where,
          fmt::format("motion.contact.offset: block {} at ({:.4g}, {:.4g}) is {}; take a smaller offset", b,
                      at.x(), at.y(), error.what()));
    }
  }
  findings.throw_if_any();
}

Handover hand_over(const Body& body, const PathEnd& end, const MotionParameters& parameters) {
  return Maker(body, end.system, parameters).make(end.state, end.has_fallen);
}

}  // namespace dda
