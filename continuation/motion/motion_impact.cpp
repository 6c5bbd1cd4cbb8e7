// What bodies that hit each other in a step leave it with.
#include <algorithm>
#include <cmath>

#include "continuation/bodies/restitution.hpp"
#include "continuation/motion/motion_try.hpp"

namespace dda {

/// What impacts give back, as far as the step has taken it, and what they take away.
void Motion::bounce(Try& step) {
  if (!course_.integrator->has_inertia() || course_.integrator->open_close()) return;
  constexpr double steps = 3;  // of falling, whose speed is that of contacts which stay
  Poses approach, velocity;
  for (std::size_t b = 0; b < now_.size(); ++b) {
    approach.push_back((step.inertia.flight[b] - now_[b]) / m_.dt.now);
    velocity.push_back(step.courses[b].velocity);
  }
  const std::vector<Meeting> meetings = potential_->meetings(step.found.poses);
  const Rebound back =
      rebound(scene_, {meetings, m_.sliders, step.found.poses, approach, velocity, steps * pull_ * m_.dt.now,
                       1 / (m_.dt.now * step.inertia.per_square_time)});
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    SliderMemory::Kept kept = step.found.contacts.of(meetings[i].key);
    kept.approach = back.under_way[i];
    step.found.contacts.set(meetings[i].key, kept);
  }
  if (back.given.empty()) return;
  calm(step, meetings, back.under_way);
  push(step, back.given);
}

/// Impacts leave no vibration of the bodies that are in them: a strain begins its way back at rest.
void Motion::calm(Try& step, const std::vector<Meeting>& meetings,
                  const std::vector<double>& under_way) const {
  std::vector<bool> is_hit(now_.size(), false);
  for (std::size_t i = 0; i < meetings.size(); ++i)
    if (under_way[i] > 0)
      for (const std::size_t b : bodies_of(meetings[i])) is_hit[b] = !scene_.bodies[b].is_held;
  MotionLedger& out = step.entry;
  const double before = out.kinetic + out.stored.sum();
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (!is_hit[b]) continue;
    const AffineBlock& block = scene_.bodies[b].block;
    out.kinetic -= kinetic_energy(block, step.courses[b].velocity);
    step.courses[b] = course_.integrator->calmed(step.courses[b], m_.dt.now);
    out.kinetic += kinetic_energy(block, step.courses[b].velocity);
  }
  out.stored = stored(step.courses);
  out.numerical -= out.kinetic + out.stored.sum() - before;
}

/// Motions more of all bodies, as far as the energy allows that the step has taken.
void Motion::push(Try& step, const std::vector<RigidMotion>& given) const {
  double linear = 0, square = 0;  // of the kinetic energy in a share of what is given back
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const AffineBlock& block = scene_.bodies[b].block;
    if (scene_.bodies[b].is_held) continue;
    const BodyCourse pushed = course_.integrator->pushed(step.courses[b], given[b], m_.dt.now);
    const Pose change = pushed.velocity - step.courses[b].velocity;
    linear += change.dot(block.times_mass(step.courses[b].velocity));
    square += kinetic_energy(block, change);
  }
  const double most = std::max(0.0, step.entry.numerical);
  double share = 1;
  if (linear + square > most)
    share = (std::sqrt(linear * linear + 4 * square * most) - linear) / (2 * square);
  double kinetic = 0;
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (scene_.bodies[b].is_held) continue;
    step.courses[b] = course_.integrator->pushed(
        step.courses[b], {share * given[b].velocity, share * given[b].spin}, m_.dt.now);
    kinetic += kinetic_energy(scene_.bodies[b].block, step.courses[b].velocity);
  }
  step.entry.numerical -= kinetic - step.entry.kinetic;
  step.entry.kinetic = kinetic;
}

}  // namespace dda
