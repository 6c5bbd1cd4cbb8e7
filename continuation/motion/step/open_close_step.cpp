#include "continuation/motion/step/open_close_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dda {
namespace {

using ContactState = OpenCloseContact::State;

/// The way of the corner less that of the foot, along a direction.
double moved_along(const Meeting& meeting, const Vec2& direction, const Poses& ways) {
  return direction.dot(
      Vec2(place_of(ways[meeting.key.body], meeting.at) - place_of(ways[meeting.key.other], meeting.foot)));
}

double smallest_size(const MovingScene& scene) {
  if (scene.smallest > 0) return scene.smallest;
  double out = std::numeric_limits<double>::infinity();
  for (const MovingBody& body : scene.bodies)
    if (!body.is_held) out = std::min(out, body.size);
  return out;
}

}  // namespace

double OpenCloseContact::gap(const Poses& ways) const {
  return slider.meeting.distance + moved_along(slider.meeting, slider.meeting.normal, ways);
}

double OpenCloseContact::slip(const Poses& ways) const {
  return slider.start + moved_along(slider.meeting, slider.tangent(), ways);
}

double OpenCloseContact::normal_force(const Poses& ways) const {
  return state == ContactState::open ? 0 : -stiffness() * gap(ways);
}

double OpenCloseContact::shear_force(const Poses& ways) const {
  if (state == ContactState::open) return 0;
  return state == ContactState::sticks ? slider.stiffness * slip(ways) : side * slider.bound;
}

bool OpenCloseContact::change(const Poses& ways) {
  const ContactState before = state;
  const double force = -stiffness() * gap(ways), u = slip(ways);
  reached = friction * std::max(0.0, force);
  if (force <= (before == ContactState::open ? hardly : -hardly) * stiffness()) {
    state = ContactState::open;
  } else if (before == ContactState::open) {
    state = friction > 0 ? ContactState::sticks : ContactState::slides;
  } else if (before == ContactState::sticks && std::abs(slider.stiffness * u) > reached) {
    state = ContactState::slides;
    side = u > 0 ? 1 : -1;
  } else if (before == ContactState::slides && friction > 0 && side * (u - slider.start) < 0) {
    state = ContactState::sticks;
    const double most = reached / slider.stiffness;
    slider.start = std::clamp(slider.start, -most, most);
  }
  return state != before;
}

double OpenCloseContact::kept(const Poses& ways) const {
  const double u = slip(ways), most = reached / slider.stiffness;
  return state == ContactState::slides ? std::clamp(u, -most, most) : u;
}

double OpenCloseContact::spent(const Poses& ways) const {
  return state == ContactState::slides ? slider.bound * std::abs(slip(ways) - kept(ways)) : 0;
}

OpenCloseStep::OpenCloseStep(const Of& of, const Integrator& integrator, const MotionTolerances& tolerances)
    : of_(of),
      integrator_(integrator),
      rules_(*integrator.open_close()),
      tolerances_(tolerances),
      entrances_(of.scene, of.search, 2.5 * rules_.displacement * smallest_size(of.scene)),
      first_order_(of.scene, of.bonds),
      longest_way_(rules_.displacement * smallest_size(of.scene)) {
  int row = 0;
  for (const MovingBody& body : of.scene.bodies) rows_.push_back(body.is_held ? -1 : row++);
}

/// Contacts as the last step has left them, by what is kept of them.
OpenCloseContact OpenCloseStep::contact_at(const Meeting& meeting, const SliderMemory& memory) const {
  constexpr double hardly = 1e-9;  // of the size of the smallest body
  const MovingScene& scene = of_.scene;
  const auto [i, j] = bodies_of(meeting);
  const double one = scene.bodies[i].modulus, other = scene.bodies[j].modulus;
  const SliderMemory::Kept kept = memory.of(meeting.key);
  OpenCloseContact out;
  out.slider.meeting = meeting;
  out.slider.meeting.stiffness = rules_.penalty * 2 * one * other / (one + other) * scene.thickness;
  out.slider.stiffness = rules_.shear_share * out.stiffness();
  out.friction = scene.meeting.friction(i, j);
  out.hardly = hardly * longest_way_ / rules_.displacement;
  const double force = kept.force > 0 ? kept.force : -out.stiffness() * meeting.distance;
  if (force <= 0) return out;
  out.slider.start = kept.slip;
  out.slider.bound = out.friction * force;
  const double shear = out.slider.stiffness * kept.slip;
  const bool slides = std::abs(shear) >= (1 - 1e-9) * out.slider.bound;
  out.state = slides ? ContactState::slides : ContactState::sticks;
  out.side = shear > 0 ? 1 : -1;
  return out;
}

void OpenCloseStep::begin(const StepStart& start, const Inertia& inertia) {
  start_ = start.poses;
  of_.potential.begin(start_);
  first_order_.begin(start.courses);
  contacts_.clear();
  for (const Meeting& meeting : entrances_.find(start_))
    contacts_.push_back(contact_at(meeting, start.sliders));
  ways_.assign(start_.size(), Pose::Zero());
  flight_ = ways_;
  for (std::size_t b = 0; b < start_.size(); ++b) {
    flight_[b] = inertia.flight[b] - start_[b];
    if (rows_[b] < 0) ways_[b] = flight_[b];
  }
  scale_ = force_scale(of_.scene, start_, inertia);
  rounding_ = of_.potential.rounding(start_, inertia.per_square_time);
}

MotionStep OpenCloseStep::solve(const StepStart& start, const Inertia& inertia) {
  begin(start, inertia);
  MotionStep out{.poses = start_, .forces = {}, .meeting = {}, .contacts = {}, .slides = {}, .failure = {}};
  for (int pass = 0;; ++pass) {
    if (pass == rules_.most_passes) {
      out.failure = fmt::format("contacts go on to open and close after {} passes", pass);
      return out;
    }
    out.failure = balance(inertia, out.iterations);
    if (!out.converged()) return out;
    if (!change_states()) break;
  }
  for (std::size_t b = 0; b < start_.size(); ++b)
    out.poses[b] = rows_[b] < 0 ? inertia.flight[b] : integrator_.carried(start_[b], ways_[b]);
  const double farthest = farthest_way(out.poses);
  if (farthest > longest_way_)
    out.failure = fmt::format("a corner goes by {:.3g}, more than {:.3g}", farthest, longest_way_);
  tell(out);
  return out;
}

/// Of a corner of what moves.
double OpenCloseStep::farthest_way(const Poses& reached) const {
  double out = 0;
  for (std::size_t b = 0; b < reached.size(); ++b)
    for (const Vec2& x : of_.scene.bodies[b].outline)
      if (rows_[b] >= 0) out = std::max(out, place_of(reached[b] - start_[b], x).norm());
  return out;
}

/// Whether any has changed; another pass follows then, with friction by the normal forces of now.
bool OpenCloseStep::change_states() {
  bool out = false;
  for (OpenCloseContact& contact : contacts_)
    if (contact.change(ways_)) out = true;
  for (OpenCloseContact& contact : contacts_)
    if (out) contact.slider.bound = contact.reached;
  return out;
}

OpenCloseStep::Vector OpenCloseStep::contact_forces() const {
  Vector out = Vector::Zero(6 * static_cast<Eigen::Index>(start_.size()));
  for (const OpenCloseContact& contact : contacts_) {
    const Meeting& meeting = contact.slider.meeting;
    const Vec2 force =
        -contact.normal_force(ways_) * meeting.normal + contact.shear_force(ways_) * contact.slider.tangent();
    const std::array<Vec6, 2> rows = rows_along(meeting, force);
    of_body(out, meeting.key.body) += rows[0];
    of_body(out, meeting.key.other) += rows[1];
  }
  return out;
}

OpenCloseStep::Vector OpenCloseStep::residual(const Inertia& inertia) const {
  Vector out = first_order_.forces(ways_) + contact_forces();
  for (std::size_t b = 0; b < start_.size(); ++b) {
    if (rows_[b] < 0)
      of_body(out, b).setZero();
    else
      of_body(out, b) +=
          inertia.per_square_time * of_.scene.bodies[b].block.times_mass(ways_[b] - flight_[b]);
  }
  return out;
}

bool OpenCloseStep::factor(double per_square_time) {
  std::vector<BlockSum::Pair> pairs;
  first_order_.add_pairs(rows_, pairs);
  for (const OpenCloseContact& contact : contacts_) {
    const auto [i, j] = bodies_of(contact.slider.meeting);
    add_pair(rows_[i], rows_[j], pairs);
  }
  const auto num_moving =
      static_cast<std::size_t>(std::ranges::count_if(rows_, [](int row) { return row >= 0; }));
  const bool has_new_pattern = sum_.set_pattern(num_moving, std::move(pairs));
  const Poses none;  // held bodies have gone their ways already
  Curvatures out(rows_, none, sum_);
  for (std::size_t b = 0; b < start_.size(); ++b)
    if (rows_[b] >= 0) out.add(b, b, per_square_time * of_.scene.bodies[b].block.mass_matrix());
  first_order_.add_stiffness(ways_, out);
  for (const OpenCloseContact& contact : contacts_) {
    if (contact.state == ContactState::open) continue;
    const Meeting& meeting = contact.slider.meeting;
    out.add(bodies_of(meeting), rows_along(meeting, meeting.normal), contact.stiffness());
    if (contact.state == ContactState::sticks)
      out.add(bodies_of(meeting), rows_along(meeting, contact.slider.tangent()), contact.slider.stiffness);
  }
  const BlockSum::Matrix& matrix = sum_.matrix();
  if (has_new_pattern) factor_.analyse(matrix);
  return factor_.factorise(matrix);
}

/// The ways for which forces balance while contacts stay as they are; why there are none.
std::string OpenCloseStep::balance(const Inertia& inertia, int& iterations) {
  constexpr int most = 60;
  for (int i = 0; i < most; ++i) {
    const Vector left = residual(inertia);
    if (i > 0 && unbalanced(of_.scene, left, rounding_).force <= tolerances_.tolerance * scale_) return {};
    if (!factor(inertia.per_square_time)) return "the stiffness is not positive definite";
    Vector right(6 * std::ranges::count_if(rows_, [](int row) { return row >= 0; }));
    for (std::size_t b = 0; b < start_.size(); ++b)
      if (rows_[b] >= 0) right.segment<6>(6 * rows_[b]) = -of_body(left, b);
    const Vector dz = factor_.solve(right);
    ++iterations;
    if (!dz.allFinite()) return "the ways are no numbers";
    for (std::size_t b = 0; b < start_.size(); ++b)
      if (rows_[b] >= 0) ways_[b] += dz.segment<6>(6 * rows_[b]);
    if (first_order_.is_linear()) return {};
  }
  return fmt::format("joints are not balanced by their secants in {} systems", most);
}

/// Forces, and what contacts keep and have spent.
void OpenCloseStep::tell(MotionStep& out) const {
  out.meeting = contact_forces();
  out.forces = first_order_.forces(ways_) + out.meeting;
  for (const OpenCloseContact& contact : contacts_) {
    if (contact.state == ContactState::open) continue;
    ++out.num_meetings;
    if (const double spent = contact.spent(ways_); spent > 0) {
      const double force = contact.shear_force(ways_);
      out.slides.push_back({.meeting = contact.slider.meeting, .force = force, .slipped = spent / force});
    }
    out.contacts.set(contact.slider.meeting.key, {contact.kept(ways_), contact.normal_force(ways_)});
  }
}

StoredEnergies OpenCloseStep::stored(const std::vector<BodyCourse>& at) const {
  Poses poses;
  for (const BodyCourse& course : at) poses.push_back(course.now);
  StoredEnergies out = of_.potential.stored(poses);
  out.strain = 0;
  for (std::size_t b = 0; b < at.size(); ++b)
    if (!of_.scene.bodies[b].is_held) out.strain += strain_energy_of(of_.scene.bodies[b].block, at[b]);
  for (const OpenCloseContact& contact : contacts_) {
    if (contact.state == ContactState::open) continue;
    out.contact += std::pow(contact.normal_force(ways_), 2) / (2 * contact.stiffness());
    out.friction += contact.slider.stiffness * std::pow(contact.kept(ways_), 2) / 2;
  }
  return out;
}

}  // namespace dda
