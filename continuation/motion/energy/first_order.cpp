#include "continuation/motion/energy/first_order.hpp"

namespace dda {
namespace {

Pose without_growth(const BodyCourse& at) {
  return pose_of(centre_of(at.now), gradient_of(at.now) / at.growth);
}

}  // namespace

double strain_energy_of(const AffineBlock& block, const BodyCourse& at) {
  return strain_energy(block, without_growth(at)).value;
}

void FirstOrder::begin(const std::vector<BodyCourse>& at) {
  start_.clear();
  strained_.clear();
  bonded_.clear();
  for (const BodyCourse& course : at) {
    const Pose y = without_growth(course);
    start_.push_back(course.now);
    strained_.push_back({green_strain(y), green_strain_rows(y) / course.growth});
  }
  for (const Bond& bond : bonds_) bonded_.push_back(dda::state_of(bond, frame_of(bond, start_), start_));
}

BondState FirstOrder::state_of(std::size_t bond, const Poses& ways) const {
  BondState out = bonded_[bond];
  const Pose &first = ways[bonds_[bond].first], &second = ways[bonds_[bond].second];
  out.opening += out.opening_rows[0] * first + out.opening_rows[1] * second;
  out.stress += out.stress_rows[0] * first + out.stress_rows[1] * second;
  return out;
}

Eigen::VectorXd FirstOrder::forces(const Poses& ways) const {
  const std::size_t n = scene_.num_bodies();
  Eigen::VectorXd out = Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(n));
  for (std::size_t b = 0; b < n; ++b) {
    if (scene_.bodies[b].is_held) continue;
    const AffineBlock& block = scene_.bodies[b].block;
    const auto& [strain, rows] = strained_[b];
    of_body(out, b) = block.volume * rows.transpose() *
                          (block.stiffness * (strain + rows * ways[b]) + block.initial_stress) -
                      scene_.load_on(b);
  }
  for (const MotionSpring& spring : scene_.springs) {
    double force = spring.stretch(start_);
    for (const auto& [b, row] : spring.rows) force += row.dot(ways[b]);
    for (const auto& [b, row] : spring.rows) of_body(out, b) += spring.stiffness * force * row;
  }
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    const BondState now = state_of(i, ways);
    const Vec2 t = bond.law->respond(now.opening, bond.history, bond.stiffness).traction;
    const std::array<Vec6, 2> forces = forces_of(bond, now, t, now.stress);
    of_body(out, bond.first) += forces[0];
    of_body(out, bond.second) += forces[1];
  }
  return out;
}

void FirstOrder::add_stiffness(const Poses& ways, Curvatures& out) const {
  for (std::size_t b = 0; b < scene_.num_bodies(); ++b) {
    const AffineBlock& block = scene_.bodies[b].block;
    const Mat36& rows = strained_[b].rows;
    if (out.wants(b, b)) out.add(b, b, block.volume * rows.transpose() * block.stiffness * rows);
  }
  for (const MotionSpring& spring : scene_.springs) out.add(spring);
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const BondState now = state_of(i, ways);
    out.add(bonds_[i], now, secant_of(bonds_[i], now.opening));
  }
}

void FirstOrder::add_pairs(const std::vector<int>& rows, std::vector<BlockSum::Pair>& out) const {
  for (const Bond& bond : bonds_) add_pair(rows[bond.first], rows[bond.second], out);
  for (const MotionSpring& spring : scene_.springs)
    for (const auto& [i, row_i] : spring.rows)
      for (const auto& [j, row_j] : spring.rows) add_pair(rows[i], rows[j], out);
}

}  // namespace dda
