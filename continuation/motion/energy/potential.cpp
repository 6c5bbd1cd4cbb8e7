#include "continuation/motion/energy/potential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "continuation/motion/energy/curvatures.hpp"
#include "models/interface/coulomb.hpp"

namespace dda {

Potential::Potential(const MovingScene& scene, const MeetingSearch& search, const std::vector<Bond>& bonds,
                     const DampingRates& damping)
    : scene_(scene), search_(search), bonds_(bonds) {
  if (damping.is_any()) damping_.emplace(scene_, bonds_, damping);
  for (const MovingBody& body : scene.bodies)
    rows_.push_back(body.is_held ? -1 : static_cast<int>(num_moving_++));
  for (const Bond& bond : bonds) add_pair(rows_[bond.first], rows_[bond.second], lasting_);
  for (std::size_t i = 0; i < bonds.size(); ++i)
    if (bonds[i].law->residual_friction().value_or(0) > 0) with_friction_.push_back(i);
  for (const MotionSpring& spring : scene.springs)
    for (const auto& [i, row_i] : spring.rows)
      for (const auto& [j, row_j] : spring.rows) add_pair(rows_[i], rows_[j], lasting_);
}

/// Makes places for all that may meet. Within a step places only come, so that few orders of elimination are sought; what
/// there was before it does not matter. Whether they are others now.
bool Potential::prepare_pattern() {
  std::vector<BlockSum::Pair> wanted = lasting_;
  for (const auto& [i, j] : pairs_) add_pair(rows_[i], rows_[j], wanted);
  for (const Slider& slider : sliders_)
    add_pair(rows_[slider.meeting.key.body], rows_[slider.meeting.key.other], wanted);
  const auto n = static_cast<std::size_t>(num_moving_);
  const bool grows = std::exchange(has_pattern_, true) && sum_.num_rows() == n;
  if (grows && sum_.covers(wanted)) return false;
  if (grows) sum_.append_pairs(wanted);
  return sum_.set_pattern(n, std::move(wanted));
}

void Potential::begin(const Poses& start) {
  start_ = start;
  has_pattern_ = false;
  near_at_.clear();
  pairs_.clear();
  if (has_meetings_) pairs_ = search_.candidates(start, start);
  frames_.clear();
  for (const Bond& bond : bonds_) frames_.push_back(frame_of(bond, start));
  if (damping_) damping_->begin(start, frames_, damped_);
  set_rubbing({});
}

std::vector<RubbingBond> Potential::rubbing(const Poses& at) const {
  std::vector<RubbingBond> out;
  for (const std::size_t i : with_friction_) {
    const Bond& bond = bonds_[i];
    const Vec2 opening = state_of(i, at).opening;
    const double k = bond.stiffness;
    const bool is_cracked = bond.law->contact(bond.history, k).has_value();
    if (!is_cracked && bond.law->equivalent_opening(opening, bond.history, k) <= bond.law->initial_kappa(k))
      continue;
    out.push_back({i, closing_of(opening), bond.weight * k * *bond.law->residual_friction()});
  }
  return out;
}

void Potential::set_rubbing(const std::vector<RubbingBond>& bonds) {
  closings_.assign(bonds_.size(), {});
  for (const RubbingBond& rubbing : bonds) closings_[rubbing.bond] = rubbing.closing;
  has_rubbing_ = !bonds.empty();
}

/// What meets, and what would after a little way. One place is asked for this again and again: for forces, for curvatures and
/// for what slides.
const std::vector<Meeting>& Potential::near(const Poses& at) const {
  constexpr double further = 1.5;  // of the reach
  if (near_at_ == at) return near_;
  near_ = search_.find(pairs_, at, further * scene_.meeting.reach);
  near_at_ = at;
  return near_;
}

std::vector<Meeting> Potential::meetings(const Poses& at) const {
  std::vector<Meeting> out;
  for_each_meeting(at, [&](const Meeting& meeting) { out.push_back(meeting); });
  return out;
}

Potential::Vector Potential::gradient(const Poses& at) const {
  const std::size_t n = scene_.num_bodies();
  Vector out = Vector::Zero(6 * static_cast<Eigen::Index>(n));
  for (std::size_t b = 0; b < n; ++b)
    if (rows_[b] >= 0) of_body(out, b) = strain_forces(scene_.bodies[b].block, at[b]) - scene_.load_on(b);
  for (const MotionSpring& spring : scene_.springs) {
    const double force = spring.stiffness * spring.stretch(at);
    for (const auto& [b, row] : spring.rows) of_body(out, b) += force * row;
  }
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    const BondState now = state_of(i, at);
    const auto forces = forces_of(bond, now, bond_response(i, now.opening).traction, now.stress);
    of_body(out, bond.first) += forces[0];
    of_body(out, bond.second) += forces[1];
  }
  if (damping_) damping_->add_forces(at, out);
  add_meeting_forces(at, out);
  return out;
}

void Potential::add_meeting_forces(const Poses& at, Vector& out) const {
  const auto push = [&](const Meeting& meeting, const Vec2& direction, double force) {
    const auto rows = rows_along(meeting, direction);
    of_body(out, meeting.key.body) += force * rows[0];
    of_body(out, meeting.key.other) += force * rows[1];
  };
  for_each_meeting(at, [&](const Meeting& meeting) {
    push(meeting, meeting.normal, -response_of(scene_.meeting, meeting).force);
  });
  for (const Slider& slider : sliders_)
    push(slider.meeting, slider.tangent(), slider.force(slider.reached(start_, at)));
}

Response Potential::bond_response(std::size_t i, const Vec2& opening) const {
  const Bond& bond = bonds_[i];
  const std::optional<double>& closing = closings_[i];
  if (histories_ == Histories::frozen)
    return frozen_response(bond, opening, closing.value_or(closing_of(opening)));
  return closing ? bond.law->respond_bounded(opening, bond.history, bond.stiffness, *closing)
                 : bond.law->respond(opening, bond.history, bond.stiffness);
}

void Potential::add_bonds(const Poses& at, Softening softening, Curvatures& out) const {
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    const BondState now = state_of(i, at);
    if (softening == Softening::secant) {
      out.add(bond, now, secant_of(bond, now.opening));
    } else {
      const Mat2 d = bond_response(i, now.opening).tangent;
      out.add(bond, now, (d + d.transpose()) / 2);
    }
  }
}

/// What touches, what would after a little way, and what slides.
void Potential::add_clamped(const Poses& at, Curvatures& sum) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  clamped_.clear();
  const auto add = [&](const Meeting& meeting, const Vec2& direction, ClampedSpring spring) {
    spring.rows = {rows_[meeting.key.body], rows_[meeting.key.other]};
    spring.along = rows_along(meeting, direction);
    if (spring.state(0) == ClampedSpring::State::within)
      sum.add(bodies_of(meeting), spring.along, spring.stiffness);
    clamped_.push_back(spring);
  };
  const MeetingRules& rules = scene_.meeting;
  for (const Meeting& meeting : near(at)) {
    const double overlap = rules.reach - meeting.distance;
    const auto [energy, force, stiffness] =
        rules.law->respond(std::max(0.0, overlap), meeting.stiffness, rules.reach);
    if (stiffness > 0)
      add(meeting, -meeting.normal,
          {.stiffness = stiffness, .at = overlap > 0 ? force / stiffness : overlap, .high = inf});
  }
  for (const Slider& slider : sliders_) {
    const double u = slider.reached(start_, at);
    add(slider.meeting, slider.tangent(),
        {.stiffness = slider.stiffness, .at = u, .low = -slider.bound, .high = slider.bound});
  }
}

Potential::Curvature Potential::curvature(const Poses& at, double per_square_time, Softening softening,
                                          const Poses& ways) {
  const bool has_new_pattern = prepare_pattern();
  Curvatures out(rows_, ways, sum_);
  for (std::size_t b = 0; b < scene_.num_bodies(); ++b)
    if (rows_[b] >= 0)
      out.add(b, b,
              per_square_time * scene_.bodies[b].block.mass_matrix() +
                  strain_energy(scene_.bodies[b].block, at[b]).curvature);
  for (const MotionSpring& spring : scene_.springs) out.add(spring);
  add_bonds(at, softening, out);
  if (damping_) damping_->add_curvature(at, out);
  add_clamped(at, out);
  return {sum_.matrix(), clamped_, out.take_pull(), has_new_pattern};
}

std::vector<double> Potential::rounding(const Poses& at, double per_square_time) const {
  constexpr double epsilon = 4 * std::numeric_limits<double>::epsilon();
  const double damped = 1 + (damping_ ? damping_->per_stiffness() : 0);
  std::vector<double> out;
  for (std::size_t b = 0; b < scene_.num_bodies(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    out.push_back(damped * body.block.volume * body.block.stiffness.maxCoeff() / body.size +
                  per_square_time * body.block.mass * centre_of(at[b]).norm());
  }
  const auto add = [&](const std::array<std::size_t, 2>& bodies, double stiffness) {
    const double places = centre_of(at[bodies[0]]).norm() + centre_of(at[bodies[1]]).norm();
    for (const std::size_t b : bodies) out[b] += stiffness * places;
  };
  for (const MotionSpring& spring : scene_.springs) {
    double sum = std::abs(spring.length);
    for (const auto& [b, row] : spring.rows) sum += row.cwiseAbs().dot(at[b].cwiseAbs());
    for (const auto& [b, row] : spring.rows) out[b] += damped * spring.stiffness * row.head<2>().norm() * sum;
  }
  for (const Bond& bond : bonds_)
    add({bond.first, bond.second}, damped * bond.weight * bond.trial_stiffness().maxCoeff());
  for_each_meeting(at, [&](const Meeting& meeting) {
    add(bodies_of(meeting), response_of(scene_.meeting, meeting).stiffness);
  });
  for (double& force : out) force *= epsilon;
  return out;
}

double Potential::value(const Poses& at) const {
  double out = stored(at).sum();
  for (std::size_t b = 0; b < scene_.num_bodies(); ++b)
    if (rows_[b] >= 0) out -= scene_.load_on(b).dot(at[b]);
  for (const Slider& slider : sliders_) out += slider.spent(slider.reached(start_, at));
  for (std::size_t i = 0; i < bonds_.size(); ++i) out += spending(bonds_[i], state_of(i, at));
  if (damping_) out += damping_->value(at);
  return out;
}

StoredEnergies Potential::stored(const Poses& at) const {
  StoredEnergies out;
  for (std::size_t b = 0; b < scene_.num_bodies(); ++b)
    if (rows_[b] >= 0) out.strain += strain_energy(scene_.bodies[b].block, at[b]).value;
  for (const MotionSpring& spring : scene_.springs)
    out.springs += spring.stiffness * std::pow(spring.stretch(at), 2) / 2;
  for (std::size_t i = 0; i < bonds_.size(); ++i) out.bonds += stored_energy(bonds_[i], state_of(i, at));
  for_each_meeting(
      at, [&](const Meeting& meeting) { out.contact += response_of(scene_.meeting, meeting).energy; });
  for (const Slider& slider : sliders_) out.friction += slider.stored(slider.reached(start_, at));
  return out;
}

}  // namespace dda
