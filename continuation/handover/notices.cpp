#include "continuation/handover/notices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "continuation/handover/regions.hpp"
#include "framework/base/disjoint_sets.hpp"

namespace dda {
namespace {

using Notices = std::vector<std::string>;
using Names = std::pair<std::string, std::string>;

const Region& region_of(const Body& body, BlockId block) {
  return body.assembly.regions[static_cast<std::size_t>(body.block(block).region)];
}

/// Regions that touch where no interface lies are bonded for ever: what they do where they meet counts nowhere.
void note_bonded_regions(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters,
                         Notices& notices) {
  std::map<Names, Names> bonded;  // regions, and their materials
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    const int first = body.block(point.first).region, second = body.block(point.second).region;
    if (point.interface >= 0 || point.cut || first == second) continue;
    if (is_held(body, parameters, first) && is_held(body, parameters, second)) continue;
    const Region &one = region_of(body, point.first), &other = region_of(body, point.second);
    bonded[{one.name, other.name}] = {one.material, other.material};
  }
  for (const auto& [regions, materials] : bonded)
    notices.push_back(fmt::format(
        "motion: regions '{}' and '{}' touch and no interface lies between them: they stay bonded, whatever "
        "`motion.contact` says; an interface `between: [{}, {}]` with a law, such as `{{type: friction, "
        "friction_angle: 30}}`, lets them slide and part",
        regions.first, regions.second, materials.first, materials.second));
}

/// Friction of a pair of materials counts where no interface has its own.
void note_own_friction(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters,
                       Notices& notices) {
  std::map<std::pair<Names, std::string>, double> of_interfaces;
  for (const InterfacePoint& point : equilibrium.interfaces().points)
    if (const auto own = point.law->residual_friction(); own && point.interface >= 0)
      of_interfaces[{
          std::minmax(region_of(body, point.first).material, region_of(body, point.second).material),
          equilibrium.interfaces().names[static_cast<std::size_t>(point.interface)]}] = *own;
  for (const PairParameters& pair : parameters.contact.pairs)
    for (const auto& [where, own] : of_interfaces)
      if (pair.friction && where.first == Names(std::minmax(pair.between[0], pair.between[1])) &&
          *pair.friction != own)
        notices.push_back(fmt::format(
            "motion.contact.pairs: blocks beside interface '{}' have the friction {:.4g} of its law, not the "
            "{:g} of the pair {}, {}, which counts for blocks of these materials that meet elsewhere",
            where.second, own, *pair.friction, pair.between[0], pair.between[1]));
}

/// Whether blocks move that no chain of joints which hold for ever connects.
bool can_meet(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters) {
  DisjointSets joined(body.assembly.num_blocks());
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p)
    if (const InterfacePoint& point = equilibrium.point(p); !point.law->can_crack() && !point.is_separate())
      joined.merge(point.first.value(), point.second.value());
  bool moves = false;
  std::set<std::size_t> groups;
  for (std::size_t b = 0; b < joined.size(); ++b) {
    groups.insert(joined.representative(b));
    moves = moves || !is_held(body, parameters, body.assembly.blocks[b].region);
  }
  return moves && groups.size() > 1;
}

/// Gravity acts beside the loads, of which the weight may be one.
void note_weight_twice(const Body& body, const Equilibrium& equilibrium, const MotionParameters& parameters,
                       Notices& notices) {
  constexpr double much = 0.5;
  const Vec2& gravity = parameters.gravity;
  if (gravity.isZero(0) || equilibrium.stages().empty()) return;
  const std::vector<double>& dead = equilibrium.stages().back().dead;
  double borne = 0, weight = 0;  // along gravity
  for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b) {
    const BlockId block{b};
    if (is_held(body, parameters, body.block(block).region)) continue;
    borne += Eigen::Map<const Vec2>(dead.data() + block_unknowns * b).dot(gravity);
    weight += body.material(block).density() * body.volume(block) * gravity.squaredNorm();
  }
  if (!(borne > much * weight)) return;
  notices.push_back(
      fmt::format("motion.gravity: acts beside the loads that the path holds, which press what moves along "
                  "it with {:.3g} "
                  "times its weight already; leave it out where the weight is a load",
                  borne / weight));
}

/// What bends a block is no motion that a body of it has.
void note_lowered(const Body& body, Notices& notices) {
  if (body.num_gradients() == 0) return;
  notices.push_back(
      "motion: blocks of second order move on as blocks of first order, which bend less easily and swing "
      "faster; where "
      "that matters take `kinematics: first_order` and smaller blocks for both");
}

/// What damps no vibration damps those of contacts neither.
void note_ringing_contacts(const Body& body, const Equilibrium& equilibrium,
                           const MotionParameters& parameters, Notices& notices) {
  const std::unique_ptr<Integrator> integrator = parameters.integrator.make();
  if (!(integrator->end_rate() > 1) || integrator->open_close() || !can_meet(body, equilibrium, parameters))
    return;
  notices.push_back(fmt::format(
      "motion.integrator: '{}' damps nothing, contacts neither: bodies that meet ring, hop, and slide where "
      "they should stick; it is for vibrations of what is joined, take 'free_flight' where bodies meet",
      parameters.integrator.name()));
}

}  // namespace

std::vector<std::string> motion_notices(const Body& body, const Equilibrium& equilibrium,
                                        const MotionParameters& parameters) {
  Notices out;
  note_ringing_contacts(body, equilibrium, parameters, out);
  note_bonded_regions(body, equilibrium, parameters, out);
  note_own_friction(body, equilibrium, parameters, out);
  note_weight_twice(body, equilibrium, parameters, out);
  note_lowered(body, out);
  return out;
}

}  // namespace dda
