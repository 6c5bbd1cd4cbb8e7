#include "continuation/bodies/restitution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "framework/base/disjoint_sets.hpp"

namespace dda {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// What an impulse of 1 along a direction does to what is held together with a body.
struct ImpactSide {
  std::size_t body, group;
  Vec2 push;      ///< of the group's centroid [1/M]
  double spin;    ///< [1/(M L)]
  Vec2 along;     ///< ± the direction
  double lever;   ///< of that about the body's centroid [L]
  double moment;  ///< and about the group's [L]

  double speed_of_group(const RigidMotion& of) const { return along.dot(of.velocity) + moment * of.spin; }
  double speed_of_body(const RigidMotion& of) const { return along.dot(of.velocity) + lever * of.spin; }
};

/// Both bodies of a contact along its normal or its tangent.
struct ImpactDirection {
  std::array<ImpactSide, 2> sides;
  double impulse = 0;  ///< λ

  double compliance() const {
    double out = 0;
    for (const ImpactSide& side : sides) out += side.along.dot(side.push) + side.moment * side.spin;
    return out;
  }
  double speed(const std::vector<RigidMotion>& of) const {
    return sides[0].speed_of_group(of[sides[0].group]) + sides[1].speed_of_group(of[sides[1].group]);
  }
  /// How fast the sides part, as rigid bodies: what a block's strain does besides is no approach.
  double speed(const MovingScene& scene, const Poses& at, const Poses& velocity) const {
    double out = 0;
    for (const ImpactSide& side : sides)
      out += side.speed_of_body(
          rigid_motion_of(scene.bodies[side.body].block, at[side.body], velocity[side.body]));
    return out;
  }
  /// To another impulse; by how much the speed changes.
  double set(double next, std::vector<RigidMotion>& of) {
    const double step = next - impulse;
    impulse = next;
    for (const ImpactSide& side : sides) {
      of[side.group].velocity += step * side.push;
      of[side.group].spin += step * side.spin;
    }
    return std::abs(step) * compliance();
  }
};

struct ImpactContact {
  ImpactDirection normal, tangent;
  double friction = 0;         ///< μ
  double given = 0;            ///< impulse of its force in the step: so much may be taken away
  double least = 0, most = 0;  ///< what the speed of parting may change by [L/T]
  double sliding = 0;          ///< speed along the tangent [L/T]
  double approach = 0;         ///< of the impact that begins, or is under way [L/T]
  double slow = 0;             ///< parting by so little is the end of an impact [L/T]
  double until = 0;            ///< from the beginning of the step to the impact; 0: it began before [T]

  /// One sweep's part; by how much speeds change.
  double relax(std::vector<RigidMotion>& of) {
    const double across = normal.compliance(), along = tangent.compliance();
    if (across <= 0) return 0;
    const auto until = [&](double wanted) { return normal.impulse + (wanted - normal.speed(of)) / across; };
    double out = normal.set(std::max(-given, std::clamp(0.0, until(least), until(most))), of);
    const double bound = friction * std::max(0.0, normal.impulse);
    if (bound == 0 && tangent.impulse == 0) return out;
    const double sticking = tangent.impulse - (sliding + tangent.speed(of)) / along;
    return out + tangent.set(std::clamp(sticking, -bound, bound), of);
  }
};

ImpactSide side_of(const Impact& impact, std::size_t body, const Vec2& arm, const Vec2& along) {
  const std::size_t group = impact.groups.of_body[body];
  const RigidGroups::Group& of = impact.groups.groups[group];
  const Vec2 from_group = centre_of(impact.at[body]) + arm - of.centroid;
  ImpactSide out{body, group, Vec2::Zero(), 0, along, cross(arm, along), cross(from_group, along)};
  if (of.is_held) return out;
  out.push = along / of.mass;
  out.spin = out.moment / of.inertia;
  return out;
}

ImpactDirection direction_of(const Impact& impact, const Meeting& meeting, const Vec2& along) {
  const std::size_t i = meeting.key.body, j = meeting.key.other;
  return {{side_of(impact, i, gradient_of(impact.at[i]) * meeting.at, along),
           side_of(impact, j, gradient_of(impact.at[j]) * meeting.foot, -along)}};
}

ImpactContact contact_of(const MovingScene& scene, const Impact& impact, const Meeting& meeting) {
  constexpr double hardly = 1e-3, touch = 1e-6;
  const std::size_t i = meeting.key.body, j = meeting.key.other;
  ImpactContact out;
  out.normal = direction_of(impact, meeting, meeting.normal);
  out.tangent = direction_of(impact, meeting, tangent_of(meeting));
  out.friction = scene.meeting.friction ? scene.meeting.friction(i, j) : 0;
  out.given = impact.span * response_of(scene.meeting, meeting).force;
  out.sliding = out.tangent.speed(scene, impact.at, impact.velocity);
  const double share = scene.meeting.restitution ? scene.meeting.restitution(i, j) : 0,
               pull = out.normal.speed(scene, impact.at, impact.pull),
               way = out.normal.speed(scene, impact.at, impact.way),
               first = out.normal.speed(scene, impact.at, impact.approach) + impact.behind * pull,
               approach = first < 0 ? std::sqrt(std::max(0.0, first * first + 2 * pull * way)) : 0,
               now = out.normal.speed(scene, impact.at, impact.velocity) +
                     (share > 0 ? impact.behind * pull : 0);
  // Of two corners that come to touch at once rounding may let one touch a step before: an impact begins where force is borne.
  const bool begins = approach > impact.slow && out.given * out.normal.compliance() > touch * approach;
  const double under_way = impact.contacts.of(meeting.key).approach;
  out.until = begins ? std::clamp(way / first, 0.0, impact.step) : 0;
  out.approach = std::max(begins ? approach : 0.0, under_way);
  out.most = out.approach > 0 ? share * out.approach - now : inf;
  const bool gives = begins || (impact.is_owed && under_way > 0);
  out.least = gives ? out.most : std::min({0.0, -now, out.most});
  out.slow = hardly * out.approach;
  return out;
}

/// Whether the vertex of a meeting meets the same body at the end of the step, if elsewhere on it.
bool is_there(const Impact& impact, const Meeting& before) {
  return std::ranges::any_of(impact.meetings, [&](const Meeting& now) {
    return now.key.body == before.key.body && now.key.vertex == before.key.vertex &&
           now.key.other == before.key.other;
  });
}

/// The impact on a body of a meeting, if there is one: the fastest.
const ImpactContact* impact_on(const Impact& impact, const Meeting& meeting,
                               const std::vector<ImpactContact>& contacts) {
  const ImpactContact* out = nullptr;
  for (const ImpactContact& contact : contacts)
    for (const ImpactSide& side : contact.normal.sides)
      for (const std::size_t body : bodies_of(meeting)) {
        const std::size_t group = impact.groups.of_body[body];
        if (contact.approach > 0 && group == side.group && !impact.groups.groups[group].is_held &&
            (!out || contact.approach > out->approach))
          out = &contact;
      }
  return out;
}

/// What contacts that an impact has parted have borne until then.
void bear_until_parted(const MovingScene& scene, const Impact& impact,
                       const std::vector<ImpactContact>& contacts, std::vector<RigidMotion>& given) {
  for (const Meeting& meeting : impact.before()) {
    const ImpactContact* hit = is_there(impact, meeting) ? nullptr : impact_on(impact, meeting, contacts);
    if (!hit) continue;
    const double time = impact.behind + hit->until, slip = impact.contacts.of(meeting.key).slip,
                 shear = scene.meeting.shear_stiffness * meeting.stiffness * slip;
    direction_of(impact, meeting, meeting.normal)
        .set(time * response_of(scene.meeting, meeting).force, given);
    direction_of(impact, meeting, tangent_of(meeting)).set(-time * shear, given);
  }
}

}  // namespace

RigidGroups::RigidGroups(const MovingScene& scene, const std::vector<MeetingSearch::Pair>& held_together,
                         const Poses& at)
    : of_body(scene.num_bodies()) {
  DisjointSets sets(scene.num_bodies());
  for (const auto& [a, b] : held_together) sets.merge(a, b);
  for (std::size_t b = 0; b < sets.size(); ++b) {
    const std::size_t first = sets.representative(b);
    of_body[b] = first == b ? groups.size() : of_body[first];
    if (first == b) groups.emplace_back();
    Group& group = groups[of_body[b]];
    group.mass += scene.bodies[b].block.mass;
    group.centroid += scene.bodies[b].block.mass * centre_of(at[b]);
    group.is_held = group.is_held || scene.bodies[b].is_held;
  }
  for (Group& group : groups) group.centroid /= group.mass;
  for (std::size_t b = 0; b < sets.size(); ++b) {
    const AffineBlock& block = scene.bodies[b].block;
    Group& group = groups[of_body[b]];
    group.inertia += block.inertia.trace() + block.mass * (centre_of(at[b]) - group.centroid).squaredNorm();
  }
}

Rebound rebound(const MovingScene& scene, const Impact& impact) {
  constexpr int sweeps = 200;
  constexpr double hardly = 1e-10;
  Rebound out{{}, std::vector<double>(impact.meetings.size(), 0.0)};
  std::vector<ImpactContact> contacts;
  double fastest = 0;
  for (const Meeting& meeting : impact.meetings) {
    contacts.push_back(contact_of(scene, impact, meeting));
    fastest = std::max(fastest, contacts.back().approach);
  }
  if (fastest <= 0) return out;
  std::vector<RigidMotion> given(impact.groups.groups.size());
  bear_until_parted(scene, impact, contacts, given);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0;
    for (ImpactContact& contact : contacts) change = std::max(change, contact.relax(given));
    if (change <= hardly * fastest) break;
  }
  for (std::size_t b = 0; b < scene.num_bodies(); ++b) {
    const std::size_t group = impact.groups.of_body[b];
    const Vec2 arm = centre_of(impact.at[b]) - impact.groups.groups[group].centroid;
    out.given.push_back(
        {given[group].velocity + given[group].spin * Vec2(-arm.y(), arm.x()), given[group].spin});
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const double now = contacts[c].normal.speed(scene, impact.at, impact.velocity);
    if (contacts[c].normal.impulse != 0 || std::abs(now) > contacts[c].slow)
      out.under_way[c] = contacts[c].approach;
  }
  return out;
}

}  // namespace dda
