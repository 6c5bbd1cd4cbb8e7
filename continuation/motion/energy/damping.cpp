#include "continuation/motion/energy/damping.hpp"

namespace dda {

void Damping::begin(const Poses& start, const std::vector<Mat2>& frames, const Step& step) {
  frames_ = frames;
  step_ = step;
  per_time_ = step.end_rate / step.dt;
  start_ = measures(start);
  origin_ = start_;
  const auto shift = [&](double rate) {
    Poses out = start;
    for (std::size_t b = 0; b < step.velocities.size(); ++b)
      out[b] += (rate - 1) / rate * step.dt * step.velocities[b];
    return out;
  };
  mean_from_ = shift(step.end_rate / 2);
  origin_.poses = shift(step.flight.rate);
  const double ahead = (step.end_rate - 1) / per_time_;
  secants_.clear();
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    secants_.push_back(secant_of(bonds_[i], start_.joints[i].opening));
  if (ahead == 0) return;
  const Poses& v = step.velocities;
  for (std::size_t b = 0; b < start.size(); ++b)
    origin_.strains[b] += ahead * green_strain_rows(start[b]) * v[b];
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

double Damping::of_mass(const Poses& now, const Poses& from) const {
  double out = 0;
  for (std::size_t b = 0; b < now.size(); ++b)
    if (!scene_.bodies[b].is_held) out += kinetic_energy(scene_.bodies[b].block, now[b] - from[b]);
  return out;
}

double Damping::of_stiffness(const Measures& now, const Measures& from) const {
  double stiffness = 0;
  for (std::size_t b = 0; b < now.poses.size(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    if (body.is_held) continue;
    const Vec3 strain = now.strains[b] - from.strains[b];
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
  return stiffness;
}

double Damping::value(const Poses& z) const {
  return per_flight_time() * rates_.mass * of_mass(z, origin_.poses) +
         per_time_ * rates_.stiffness * of_stiffness(measures(z), origin_);
}

double Damping::spent(const Poses& reached) const {
  const double mean = step_.end_rate / 2 / step_.dt;
  return 2 * step_.flight.span * mean * mean * rates_.mass * of_mass(reached, mean_from_) +
         2 / step_.dt * rates_.stiffness * of_stiffness(measures(reached), start_);
}

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
    of_body(out, b) += rates_.mass * per_flight_time() * body.block.times_mass(z[b] - origin_.poses[b]);
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
    Mat6 of = rates_.mass * per_flight_time() * body.block.mass_matrix();
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
