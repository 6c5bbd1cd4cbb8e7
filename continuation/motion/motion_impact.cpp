// What bodies that hit each other in a step leave it with.
#include <algorithm>
#include <cmath>

#include "continuation/motion/motion_try.hpp"

namespace dda {

/// Pairs of bodies that joints still hold together, where impacts give something back.
std::vector<MeetingSearch::Pair> Motion::held_together() const {
  std::vector<MeetingSearch::Pair> out;
  if (!scene_.meeting.restitution) return out;
  for (const Bond& bond : bonds_)
    if (bond.holds()) out.emplace_back(bond.first, bond.second);
  return out;
}

/// How bodies fly and are led in a step.
struct Motion::Encounter {
  Poses approach, velocity, pull, way;
};

Motion::Encounter Motion::encounter(const Try& step) const {
  const std::vector<AsOne> pulled = as_one(step);
  Encounter out;
  out.pull.assign(now_.size(), Pose::Zero());
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (!scene_.bodies[b].is_held) out.pull[b].head<2>() = pulled[b].pull;
    out.approach.push_back((step.inertia.flight[b] - now_[b]) / m_.dt.now);
    out.velocity.push_back(step.courses[b].velocity);
    out.way.push_back(step.found.poses[b] - now_[b]);
  }
  return out;
}

/// What impacts give back, as far as they have taken it, and what they take away.
void Motion::bounce(Try& step) {
  if (course_.integrator->open_close()) return;
  if (!course_.integrator->has_inertia()) return hold(step, 0);
  const std::function before = [&] { return potential_->meetings(now_); };
  const std::vector<Meeting> meetings = potential_->meetings(step.found.poses);
  if (meetings.empty() && m_.owed.empty()) return hold(step, 0);
  constexpr double steps = 3;  // of falling, whose speed is that of contacts which stay
  const Encounter met = encounter(step);
  const RigidGroups groups(scene_, held_together(), step.found.poses);
  const Rebound back =
      rebound(scene_, {.meetings = meetings,
                       .before = before,
                       .contacts = m_.sliders,
                       .at = step.found.poses,
                       .approach = met.approach,
                       .velocity = met.velocity,
                       .pull = met.pull,
                       .way = met.way,
                       .step = m_.dt.now,
                       .behind = course_.integrator->has_mean_velocities() ? m_.dt.now / 2 : 0,
                       .slow = steps * pull_ * m_.dt.now,
                       .span = 1 / (m_.dt.now * step.inertia.per_square_time),
                       .groups = groups,
                       .is_owed = !m_.owed.empty()});
  std::vector<std::size_t> hit;
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    SliderMemory::Kept kept = step.found.contacts.of(meetings[i].key);
    kept.approach = back.under_way[i];
    step.found.contacts.set(meetings[i].key, kept);
    if (back.under_way[i] > 0)
      for (const std::size_t b : bodies_of(meetings[i])) hit.push_back(groups.of_body[b]);
  }
  if (!back.given.empty()) calm(step, hit, groups);
  const std::vector<RigidMotion> given = back.given.empty() ? std::move(m_.owed) : back.given;
  m_.owed.clear();
  if (!given.empty()) push(step, given);
  const bool is_over = hit.empty() && m_.owed.empty();
  const double since_it_began = scene_.meeting.restitution ? step.entry.stored.impacts : 0;
  hold(step, is_over ? 0 : std::max(0.0, since_it_began + step.entry.lost()));
}

/// What impacts under way have taken is spent when they are over, less what they have given back. That may be of what the
/// vibrations of bodies in them have lost. Where they give nothing back that is so of the last step: its velocity, a mean of
/// that before and after an impact, which may point against each other, has less kinetic energy than either; the next one tells.
/// No impact gives what it has not taken: what contacts seem to is made by the steps, and goes back to them when contacts take it again.
void Motion::hold(Try& step, double energy) {
  MotionLedger& out = step.entry;
  out.impact -= energy - out.stored.impacts;
  out.stored.impacts = energy;
  const double more = std::clamp(-out.impact, 0.0, std::max(0.0, out.numerical));
  const double taken = out.impact + more - m_.overdrawn;
  m_.overdrawn = std::max(0.0, -taken);
  out.numerical += out.impact - std::max(0.0, taken);
  out.impact = std::max(0.0, taken);
}

/// Impacts leave no vibration of the bodies that are in them: a strain begins its way back at rest.
void Motion::calm(Try& step, const std::vector<std::size_t>& hit, const RigidGroups& groups) const {
  std::vector<bool> is_hit(groups.groups.size(), false);
  for (const std::size_t group : hit) is_hit[group] = true;
  MotionLedger& out = step.entry;
  const double before = out.kinetic + out.stored.sum();
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (!is_hit[groups.of_body[b]] || scene_.bodies[b].is_held) continue;
    const AffineBlock& block = scene_.bodies[b].block;
    out.kinetic -= kinetic_energy(block, step.courses[b].velocity);
    step.courses[b] = course_.integrator->calmed(block, step.courses[b], m_.dt.now);
    out.kinetic += kinetic_energy(block, step.courses[b].velocity);
  }
  out.stored = stored(step.courses);
  out.stored.impacts = m_.ledger.stored.impacts;
  out.impact -= out.kinetic + out.stored.sum() - before;
}

/// Motions more of all bodies, as far as the energy allows that the impacts have taken; the rest is owed for as long as they
/// still take some, bodies vibrating that were pressed together.
void Motion::push(Try& step, const std::vector<RigidMotion>& given) {
  double linear = 0, square = 0;  // of the kinetic energy in a share of what is given back
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const AffineBlock& block = scene_.bodies[b].block;
    if (scene_.bodies[b].is_held) continue;
    const BodyCourse pushed = course_.integrator->pushed(step.courses[b], given[b], m_.dt.now);
    const Pose change = pushed.velocity - step.courses[b].velocity;
    linear += change.dot(block.times_mass(step.courses[b].velocity));
    square += kinetic_energy(block, change);
  }
  const double most = std::max(0.0, step.entry.stored.impacts + step.entry.lost());
  double share = 1;
  if (linear + square > most)
    share = (std::sqrt(linear * linear + 4 * square * most) - linear) / (2 * square);
  constexpr double hardly = 1e-6;
  if (share < 1 && most > hardly * step.entry.kinetic)
    for (const RigidMotion& motion : given)
      m_.owed.push_back({(1 - share) * motion.velocity, (1 - share) * motion.spin});
  double kinetic = 0;
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (scene_.bodies[b].is_held) continue;
    step.courses[b] = course_.integrator->pushed(
        step.courses[b], {share * given[b].velocity, share * given[b].spin}, m_.dt.now);
    kinetic += kinetic_energy(scene_.bodies[b].block, step.courses[b].velocity);
  }
  step.entry.impact -= kinetic - step.entry.kinetic;
  step.entry.kinetic = kinetic;
}

}  // namespace dda
