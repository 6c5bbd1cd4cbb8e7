#include "continuation/bodies/restitution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dda {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// What an impulse of 1 along a direction does to a body.
struct ImpactSide {
  std::size_t body;
  Vec2 push;      ///< of the centroid [1/M]
  double spin;    ///< [1/(M L)]
  Vec2 along;     ///< ± the direction
  double moment;  ///< of that about the centroid [L]

  double speed(const RigidMotion& of) const { return along.dot(of.velocity) + moment * of.spin; }
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
    return sides[0].speed(of[sides[0].body]) + sides[1].speed(of[sides[1].body]);
  }
  /// How fast the sides part, as rigid bodies: what a block's strain does besides is no approach.
  double speed(const Poses& at, const Poses& velocity) const {
    double out = 0;
    for (const ImpactSide& side : sides) out += side.speed(rigid_part(at[side.body], velocity[side.body]));
    return out;
  }
  /// To another impulse; by how much the speed changes.
  double set(double next, std::vector<RigidMotion>& of) {
    const double step = next - impulse;
    impulse = next;
    for (const ImpactSide& side : sides) {
      of[side.body].velocity += step * side.push;
      of[side.body].spin += step * side.spin;
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

ImpactSide side_of(const MovingScene& scene, std::size_t body, const Vec2& arm, const Vec2& along) {
  ImpactSide out{body, Vec2::Zero(), 0, along, cross(arm, along)};
  if (scene.bodies[body].is_held) return out;
  const AffineBlock& block = scene.bodies[body].block;
  out.push = along / block.mass;
  out.spin = out.moment / block.inertia.trace();
  return out;
}

ImpactDirection direction_of(const MovingScene& scene, const Meeting& meeting, const Poses& at,
                             const Vec2& along) {
  const std::size_t i = meeting.key.body, j = meeting.key.other;
  return {{side_of(scene, i, gradient_of(at[i]) * meeting.at, along),
           side_of(scene, j, gradient_of(at[j]) * meeting.foot, -along)}};
}

ImpactContact contact_of(const MovingScene& scene, const Impact& impact, const Meeting& meeting) {
  constexpr double hardly = 1e-3;
  const std::size_t i = meeting.key.body, j = meeting.key.other;
  ImpactContact out;
  out.normal = direction_of(scene, meeting, impact.at, meeting.normal);
  out.tangent = direction_of(scene, meeting, impact.at, tangent_of(meeting));
  out.friction = scene.meeting.friction ? scene.meeting.friction(i, j) : 0;
  out.given = impact.span * response_of(scene.meeting, meeting).force;
  out.sliding = out.tangent.speed(impact.at, impact.velocity);
  const double approach = -out.normal.speed(impact.at, impact.approach),
               now = out.normal.speed(impact.at, impact.velocity);
  const double share = scene.meeting.restitution ? scene.meeting.restitution(i, j) : 0;
  const bool begins = approach > impact.slow;
  out.approach = begins ? approach : impact.contacts.of(meeting.key).approach;
  out.most = out.approach > 0 ? share * out.approach - now : inf;
  out.least = begins ? out.most : std::min({0.0, -now, out.most});
  out.slow = hardly * out.approach;
  return out;
}

}  // namespace

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
  out.given.resize(scene.num_bodies());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0;
    for (ImpactContact& contact : contacts) change = std::max(change, contact.relax(out.given));
    if (change <= hardly * fastest) break;
  }
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const double now = contacts[c].normal.speed(impact.at, impact.velocity);
    if (contacts[c].normal.impulse != 0 || std::abs(now) > contacts[c].slow)
      out.under_way[c] = contacts[c].approach;
  }
  return out;
}

}  // namespace dda
