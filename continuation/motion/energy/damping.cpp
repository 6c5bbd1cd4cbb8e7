#include "continuation/motion/energy/damping.hpp"

namespace dda {

void Damping::begin(const Poses& start, const std::vector<Mat2>& frames, const Step& step) {
  frames_ = frames;
  dt_ = step.dt;
  per_time_ = step.end_rate / step.dt;
  start_ = measures(start);
  origin_ = start_;
  const double ahead = (step.end_rate - 1) / per_time_;
  secants_.clear();
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    secants_.push_back(secant_of(bonds_[i], start_.joints[i].opening));
  if (ahead == 0) return;
  const Poses& v = step.velocities;
  for (std::size_t b = 0; b < start.size(); ++b) {
    origin_.poses[b] += ahead * v[b];
    origin_.strains[b] += ahead * green_strain_rows(start[b]) * v[b];
  }
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    const BondState at = state_of(bond, frames_[i], start);
    origin_.joints[i].opening +=
        ahead * (at.opening_rows[0] * v[bond.first] + at.opening_rows[1] * v[bond.second]);
    origin_.joints[i].stress +=
        ahead * (at.stress_rows[0] * v[bond.first] + at.stress_rows[1] * v[bond.second]);
  }
  for (std::size_t s = 0; s < scene_.springs.size(); ++s)
    for (const auto& [b, row] : scene_.springs[s].rows) origin_.stretches[s] += ahead * row.dot(v[b]);
}

Damping::Measures Damping::measures(const Poses& at) const {
  Measures out{at, {}, {}, {}};
  for (const Pose& y : at) out.strains.push_back(green_strain(y));
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const BondState state = state_of(bonds_[i], frames_[i], at);
    out.joints.push_back({state.opening, state.stress});
  }
  for (const MotionSpring& spring : scene_.springs) out.stretches.push_back(spring.stretch(at));
  return out;
}

double Damping::energy(const Measures& now, const Measures& from) const {
  double mass = 0, stiffness = 0;
  for (std::size_t b = 0; b < now.poses.size(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    if (body.is_held) continue;
    const Pose way = now.poses[b] - from.poses[b];
    const Vec3 strain = now.strains[b] - from.strains[b];
    mass += way.dot(body.block.times_mass(way)) / 2;
    stiffness += body.block.volume / 2 * strain.dot(body.block.stiffness * strain);
  }
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Vec2 opening = now.joints[i].opening - from.joints[i].opening,
               stress = now.joints[i].stress - from.joints[i].stress;
    stiffness +=
        bonds_[i].weight / 2 *
        (opening.dot(secants_[i] * opening) - stress.dot(stress.cwiseQuotient(bonds_[i].trial_stiffness())));
  }
  for (std::size_t s = 0; s < now.stretches.size(); ++s) {
    const double stretch = now.stretches[s] - from.stretches[s];
    stiffness += scene_.springs[s].stiffness / 2 * stretch * stretch;
  }
  return rates_.mass * mass + rates_.stiffness * stiffness;
}

double Damping::value(const Poses& z) const { return per_time_ * energy(measures(z), origin_); }

double Damping::spent(const Poses& reached) const { return 2 / dt_ * energy(measures(reached), start_); }

/// Its strain energy is what damping adds to that of a body, but for a constant.
AffineBlock Damping::viscous(std::size_t body) const {
  AffineBlock out = scene_.bodies[body].block;
  out.stiffness *= per_stiffness();
  out.initial_stress = -out.stiffness * origin_.strains[body];
  return out;
}

void Damping::add_forces(const Poses& z, Eigen::VectorXd& out) const {
  for (std::size_t b = 0; b < z.size(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    if (body.is_held) continue;
    of_body(out, b) += rates_.mass * per_time_ * body.block.times_mass(z[b] - origin_.poses[b]);
    if (rates_.stiffness > 0) of_body(out, b) += strain_forces(viscous(b), z[b]);
  }
  const double share = per_stiffness();
  if (share == 0) return;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    const BondState now = state_of(bond, frames_[i], z);
    const auto forces = forces_of(bond, now, secants_[i] * (now.opening - origin_.joints[i].opening),
                                  now.stress - origin_.joints[i].stress);
    of_body(out, bond.first) += share * forces[0];
    of_body(out, bond.second) += share * forces[1];
  }
  for (std::size_t s = 0; s < scene_.springs.size(); ++s) {
    const MotionSpring& spring = scene_.springs[s];
    const double force = share * spring.stiffness * (spring.stretch(z) - origin_.stretches[s]);
    for (const auto& [b, row] : spring.rows) of_body(out, b) += force * row;
  }
}

void Damping::add_curvature(const Poses& z, Curvatures& out) const {
  for (std::size_t b = 0; b < z.size(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    if (body.is_held) continue;
    Mat6 of = rates_.mass * per_time_ * body.block.mass_matrix();
    if (rates_.stiffness > 0) of += strain_energy(viscous(b), z[b]).curvature;
    out.add(b, b, of);
  }
  const double share = per_stiffness();
  if (share == 0) return;
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    out.add(bonds_[i], state_of(bonds_[i], frames_[i], z), secants_[i], share);
  for (const MotionSpring& spring : scene_.springs) out.add(spring, share);
}

}  // namespace dda
