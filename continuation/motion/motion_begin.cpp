// Where a motion begins: how fast things will go, what is stored, and that nothing is inside of anything else.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "continuation/motion/motion.hpp"

namespace dda {

double pull_on(const MovingScene& scene, const Poses& velocities) {
  double mass = 0, thrown = 0;
  Vec2 load = Vec2::Zero();
  for (std::size_t b = 0; b < scene.num_bodies(); ++b) {
    const MovingBody& body = scene.bodies[b];
    if (body.is_held) continue;
    mass += body.block.mass;
    load += scene.load_on(b).head<2>();
    thrown = std::max(thrown, centre_of(velocities[b]).squaredNorm() / body.size);
  }
  const double out = std::max(scene.gravity.norm(), load.norm() / mass);
  return out > 0 ? out : thrown;
}

double pace_of(const MovingScene& scene, double pull) {
  double size = std::numeric_limits<double>::infinity();
  for (const MovingBody& body : scene.bodies)
    if (!body.is_held) size = std::min(size, body.size);
  return std::sqrt((scene.smallest > 0 ? scene.smallest : size) / pull);
}

/// Cores that cross tell no outside: nothing would hold one body off the other.
void Motion::require_apart() {
  const auto pair = search_->crossing(now_);
  if (!pair) return;
  const auto [i, j] = *pair;
  const Vec2 one = centre_of(now_[i]), other = centre_of(now_[j]);
  ending_ = Ending::failed;
  stop_ = Stop::overlap;
  reason_ = fmt::format(
      "blocks {} at ({:.4g}, {:.4g}) and {} at ({:.4g}, {:.4g}) overlap where it begins; where they have "
      "turned about "
      "points inside their sides, an interface with `points: vertices` has them turn about their corners",
      i, one.x(), one.y(), j, other.x(), other.y());
}

/// Joints that are opened beyond what they remember where it begins, by the equilibrium that it begins with, have spent that
/// before: no step has. What loses its strength at once does so in a step, on the way.
void Motion::open_bonds() {
  for (Bond& bond : bonds_) {
    if (bond.is_spent() || bond.law->releases_at_once()) continue;
    const BondState here = state_of(bond, frame_of(bond, now_), now_);
    const double spent = spending(bond, here);
    m_.ledger.fracture += spent;
    if (bond.interface >= 0) m_.ledger.fracture_of[static_cast<std::size_t>(bond.interface)] += spent;
    bond.history = bond.law->accept(here.opening, bond.history, bond.stiffness);
  }
}

/// Energies and accelerations at the beginning, damped as if a step had led there.
void Motion::begin_energies() {
  Poses before;
  for (const BodyCourse& course : m_.courses) before.push_back(course.before);
  potential_->set_damped({velocities(), natural_, 1});
  potential_->begin(before);
  const Eigen::VectorXd forces = potential_->gradient(now_);
  Eigen::VectorXd of_contacts = Eigen::VectorXd::Zero(forces.size());
  potential_->add_meeting_forces(now_, of_contacts);
  keep_forces(forces, of_contacts);
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    if (body.is_held) continue;
    m_.courses[b].acceleration = body.block.over_mass(-of_body(forces, b));
    m_.ledger.kinetic += kinetic_energy(body.block, m_.courses[b].velocity);
  }
  potential_->begin(now_);
  m_.ledger.stored = stored(m_.courses);
}

}  // namespace dda
