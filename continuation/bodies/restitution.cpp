#include "continuation/bodies/restitution.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace dda {
namespace {

/// What an impulse of 1 along the normal does to a body.
struct ImpactSide {
  std::size_t body;
  Vec2 push;      ///< of the centroid [1/M]
  double spin;    ///< [1/(M L)]
  Vec2 along;     ///< ± n
  double moment;  ///< of ± n about the centroid [L]

  double speed(const RigidMotion& of) const { return along.dot(of.velocity) + moment * of.spin; }
};

struct ImpactContact {
  std::array<ImpactSide, 2> sides;
  double target;       ///< speed of parting that is missing [L/T]
  double impulse = 0;  ///< λ

  double compliance() const {
    double out = 0;
    for (const ImpactSide& side : sides) out += side.along.dot(side.push) + side.moment * side.spin;
    return out;
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

/// How fast the sides of a contact part, as rigid bodies: what a block's strain does besides is no approach.
double parting(const std::array<ImpactSide, 2>& sides, const Poses& at, const Poses& velocity) {
  double out = 0;
  for (const ImpactSide& side : sides) out += side.speed(rigid_part(at[side.body], velocity[side.body]));
  return out;
}

}  // namespace

std::vector<RigidMotion> rebound(const MovingScene& scene, const Impact& impact) {
  constexpr int sweeps = 200;
  constexpr double hardly = 1e-10;
  std::vector<ImpactContact> contacts;
  double largest = 0;
  for (const Meeting& meeting : impact.meetings) {
    const std::size_t i = meeting.key.body, j = meeting.key.other;
    const std::array<ImpactSide, 2> sides{
        side_of(scene, i, gradient_of(impact.at[i]) * meeting.at, meeting.normal),
        side_of(scene, j, gradient_of(impact.at[j]) * meeting.foot, -meeting.normal)};
    const double approach = -parting(sides, impact.at, impact.approach),
                 now = parting(sides, impact.at, impact.velocity);
    const double share = approach > impact.slow ? scene.meeting.restitution(i, j) : 0;
    const double target = share > 0 ? share * approach - now : std::min(0.0, -now);
    contacts.push_back({sides, target});
    if (share > 0) largest = std::max(largest, target);
  }
  if (largest <= 0) return {};
  std::vector<RigidMotion> out(scene.num_bodies());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0;
    for (ImpactContact& contact : contacts) {
      double speed = 0;
      for (const ImpactSide& side : contact.sides) speed += side.speed(out[side.body]);
      const double compliance = contact.compliance();
      if (compliance <= 0) continue;
      const double next = std::max(0.0, contact.impulse + (contact.target - speed) / compliance),
                   step = next - contact.impulse;
      contact.impulse = next;
      change = std::max(change, std::abs(step) * compliance);
      for (const ImpactSide& side : contact.sides) {
        out[side.body].velocity += step * side.push;
        out[side.body].spin += step * side.spin;
      }
    }
    if (change <= hardly * largest) break;
  }
  return out;
}

}  // namespace dda
