#include "continuation/motion/motion.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "continuation/bodies/joined.hpp"
#include "continuation/motion/motion_try.hpp"
#include "continuation/motion/step/open_close_step.hpp"
#include "continuation/motion/step/step_minimum.hpp"

namespace dda {
namespace {

constexpr double of_tearing = 0.1;  // of the step, while joints tear
constexpr double grows_below =
    0.3;  // of the error that is allowed: a step half as long again has more than twice as much
constexpr double smallest = 1.0 / 4096;  // of the natural step

}  // namespace

Motion::Motion(const MovingScene& scene, std::vector<Bond> bonds, Poses poses, Poses velocities,
               const MotionCourse& course)
    : scene_(scene), bonds_(std::move(bonds)), course_(course), now_(std::move(poses)), start_(now_) {
  if (!course_.integrator) course_.integrator = integrators().choose(Node::scalar("free_flight")).make();
  pull_ = pull_on(scene, velocities);
  natural_ = course_.step * pace_of(scene, pull_);
  if (!std::isfinite(natural_)) natural_ = course_.time > 0 ? course_.time / 1000 : 1;
  m_.dt = {natural_, natural_, true};
  m_.tears =
      std::ranges::any_of(bonds_, [](const Bond& bond) { return bond.can_tear() && !bond.is_spent(); });
  for (std::size_t b = 0; b < now_.size(); ++b)
    m_.courses.push_back(course_.integrator->begin(now_[b], velocities[b], natural_));
  for (const Bond& bond : bonds_)
    if (const auto number = static_cast<std::size_t>(bond.interface + 1);
        number > m_.ledger.fracture_of.size())
      m_.ledger.fracture_of.resize(number);
  m_.bonds.resize(bonds_.size());
  std::iota(m_.bonds.begin(), m_.bonds.end(), std::size_t{0});
  for (const Bond& bond : bonds_) m_.joined.push_back(pair_of(bond));
  put_in_order(m_.joined);
  search_ = std::make_unique<MeetingSearch>(scene_, m_.joined);
  open_bonds();
  release();
  begin_energies();
  require_apart();
}

void Motion::restore(MotionMemory memory, const std::vector<Bond>& bonds) {
  m_ = std::move(memory);
  bonds_.clear();
  for (std::size_t i = 0; i < m_.bonds.size(); ++i) {
    bonds_.push_back(bonds.at(m_.bonds[i]));
    bonds_.back().history = m_.histories[i];
  }
  m_.histories.clear();
  joined_ = JoinedBodies(scene_, bonds_);
  for (std::size_t b = 0; b < now_.size(); ++b) now_[b] = m_.courses[b].now;
  make_solver();
  end_if_due();
}

/// For what is bonded and joined now.
void Motion::make_solver() {
  search_ = std::make_unique<MeetingSearch>(scene_, m_.joined);
  const bool opens_and_closes = course_.integrator->open_close() != nullptr;
  potential_ = std::make_unique<Potential>(scene_, *search_, bonds_, course_.damping);
  if (opens_and_closes) {
    potential_->leave_out_meetings();
    solver_ = std::make_unique<OpenCloseStep>(OpenCloseStep::Of{scene_, *search_, bonds_, *potential_},
                                              *course_.integrator, course_.tolerances);
  } else {
    solver_ = std::make_unique<StepMinimum>(scene_, *potential_, course_.tolerances);
  }
  potential_->begin(now_);
}

MotionMemory Motion::memory() const {
  MotionMemory out = m_;
  for (const Bond& bond : bonds_) out.histories.push_back(bond.history);
  return out;
}

Poses Motion::velocities() const {
  Poses out;
  for (const BodyCourse& course : m_.courses) out.push_back(course.velocity);
  return out;
}

/// How far the last step has moved a body, turns of a size included.
double Motion::travelled(std::size_t body, double turned) const {
  return (centre_of(now_[body]) - centre_of(m_.courses[body].before)).norm() +
         turned * scene_.bodies[body].size;
}

/// The longest step that turns no body by more than 0.1, moves none that may meet another by more than a fifth of its size, and
/// no corner by more than most of what the solver bears.
double Motion::longest() const {
  constexpr double turn = 0.1, most = 0.8;
  constexpr double without_inertia = 1e3;  // no motion is missed by a step that is long
  double out = natural_ * (m_.tears ? of_tearing : course_.integrator->has_inertia() ? 1 : without_inertia);
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (scene_.bodies[b].is_held) continue;
    const Pose& before = m_.courses[b].before;
    const double turned = std::abs(
        std::remainder(polar_of(gradient_of(now_[b])).angle - polar_of(gradient_of(before)).angle, 2 * M_PI));
    if (turned > 0) out = std::min(out, m_.dt.before * turn / turned);
    if (const double all = travelled(b, turned); solver_->longest_way() > 0 && all > 0)
      out = std::min(out, m_.dt.before * most * solver_->longest_way() / all);
  }
  return out;
}

/// The longest step, no longer than one, in which no body that may meet another goes farther than a fifth of its size; how fast
/// it goes does not matter to one that meets nothing.
double Motion::longest_among_others(double dt) const {
  for (;; dt /= 2) {
    const double bound = bound_of_meeting(dt);
    if (bound >= dt) return dt;
    if (bound >= dt / 2) return bound;
  }
}

/// By how long a step is bounded in which bodies go on for so long as they have come here; looked for among those that go far.
double Motion::bound_of_meeting(double dt) const {
  constexpr double way = 0.2;
  constexpr double inf = std::numeric_limits<double>::infinity();
  std::vector<double> bounds(now_.size(), inf);
  double shortest = inf, margin = 0;
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (scene_.bodies[b].is_held) continue;
    const double moved = (centre_of(now_[b]) - centre_of(m_.courses[b].before)).norm();
    margin = std::max(margin, way * scene_.bodies[b].size);
    if (moved > 0) bounds[b] = m_.dt.before * way * scene_.bodies[b].size / moved;
    shortest = std::min(shortest, bounds[b]);
  }
  if (shortest >= dt) return inf;
  Poses ahead = now_;
  for (std::size_t b = 0; b < now_.size(); ++b)
    ahead[b] += dt / m_.dt.before * (now_[b] - m_.courses[b].before);
  double out = inf;
  for (const auto& [i, j] : search_->candidates(now_, ahead, scene_.meeting.reach + 2 * margin))
    out = std::min({out, bounds[i], bounds[j]});
  return out;
}

/// Where inertia takes bodies in the step; what is held stays, or goes where it is driven.
Inertia Motion::aim() const {
  Inertia out{now_, {}, course_.integrator->per_square_time(m_.dt)};
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (!scene_.bodies[b].is_held)
      out.flight[b] = course_.integrator->flight(scene_.bodies[b].block, m_.courses[b], m_.dt);
  for (const Drive& drive : scene_.drives)
    for (const std::size_t b : drive.bodies) out.flight[b] = start_[b];
  for (const Drive& drive : scene_.drives)
    for (const std::size_t b : drive.bodies)
      out.flight[b].head<2>() += drive.displacement->at(m_.time + m_.dt.now) * drive.direction;
  out.likely = out.flight;
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (!scene_.bodies[b].is_held) out.likely[b] += m_.courses[b].acceleration / out.per_square_time;
  return out;
}

/// The length of the next step: longer after some that went well, as long as the clock and the end allow.
void Motion::set_step() {
  constexpr double growth = 1.5;
  const int few = course_.accuracy ? 1 : 5;
  if (m_.easy >= few) {
    m_.dt.now *= growth;
    m_.easy = 0;
  }
  m_.dt.now = longest_among_others(std::min(m_.dt.now, longest()));
  const double left = course_.time - m_.time;
  if (course_.time > 0 && m_.dt.now > (1 - 1e-9) * left) m_.dt.now = left;
  land_on_kink();
}

/// A step ends where the velocity of what is driven jumps, and the one before it takes half of what is left rather than nearly all.
void Motion::land_on_kink() {
  constexpr double hardly = 1e-6;
  const double here = m_.time + hardly * m_.dt.now;
  double left = std::numeric_limits<double>::infinity();
  for (const Drive& drive : scene_.drives)
    left = std::min(left, drive.displacement->next_kink(here) - m_.time);
  if (m_.dt.now > (1 - 1e-9) * left)
    m_.dt.now = left;
  else if (m_.dt.now > left / 2)
    m_.dt.now = left / 2;
}

/// How damping acts in a step; velocities that are means are those with which bodies fly on.
Damping::Step Motion::damped(const Inertia& inertia) const {
  Poses from = velocities();
  for (std::size_t b = 0; course_.integrator->has_mean_velocities() && b < from.size(); ++b)
    from[b] = (inertia.flight[b] - now_[b]) / m_.dt.now;
  return {std::move(from), m_.dt.now, course_.integrator->end_rate(),
          course_.integrator->damped_flight(course_.damping.mass, m_.dt)};
}

Motion::Try Motion::try_step() {
  Try out{aim(), {}};
  potential_->set_damped(damped(out.inertia));
  out.found = solver_->solve({now_, m_.courses, m_.sliders}, out.inertia);
  m_.iterations += out.found.iterations;
  if (!out.found.converged()) return out;
  book(out);
  if (creates_energy(out))
    out.found.failure = fmt::format("the step would create an energy of {:.3g}", -out.entry.lost());
  return out;
}

/// The length to try a step again with that is too long for what tears in it, or for the accuracy of places; 0 where it is not.
double Motion::shorter_step(const Try& step, bool is_overloaded) const {
  const double tearing = of_tearing * natural_, quarter = m_.dt.now / 4;
  if ((step.entry.fracture > 0 || is_overloaded) && m_.dt.now > (1 + 1e-9) * tearing)
    return std::max(tearing, quarter);
  if (!step.found.converged() || m_.dt.now <= smallest * natural_) return 0;
  if (tears_unfelt(step)) return std::max(smallest * natural_, quarter);
  const double error = error_of(step);
  return error > 1 ? std::max({smallest * natural_, quarter, 0.9 * m_.dt.now / std::sqrt(error)}) : 0;
}

bool Motion::advance() {
  if (ending_ != Ending::none) return false;
  set_step();
  given_up_.clear();
  for (;;) {
    Try step = try_step();
    const auto overloaded = step.found.converged() ? overloads(step.found.poses) : std::vector<Overload>{};
    if (const double shorter = shorter_step(step, !overloaded.empty()); shorter > 0) {
      m_.dt.now = shorter;
      m_.easy = 0;
      take_back_strength();
      continue;
    }
    if (!overloaded.empty()) {
      lose_strength(overloaded);
      continue;
    }
    if (step.found.converged()) {
      const double error = error_of(step);
      accept(std::move(step));
      if (error > grows_below) m_.easy = 0;
      judge();
      return true;
    }
    ++m_.rejected;
    m_.easy = 0;
    take_back_strength();
    reason_ = step.found.failure;
    m_.dt.now *= solver_->cut();
    if (m_.dt.now < smallest * natural_) {
      ending_ = Ending::failed;
      stop_ = Stop::no_step;
      reason_ = fmt::format("no step of {:.3g} was found: {}", m_.dt.now / solver_->cut(), reason_);
      return false;
    }
  }
}

/// What the bonds remember; whether one has been spent. A corner that is pressed may never tear: bodies that have turned over it
/// so far that other sides of theirs may meet are held by it no longer.
bool Motion::crack(const MotionStep& step) {
  constexpr double over = 0.7;
  bool has_parted = !given_up_.empty();
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    Bond& bond = bonds_[i];
    const bool was_spent = bond.is_spent();
    const Vec2 opening = potential_->state_of(i, step.poses).opening;
    bond.history = bond.law->accept(opening, bond.history, bond.stiffness);
    if (bond.can_tear() && !bond.is_spent() && turn_of(bond, step.poses) > over) spend(bond, opening);
    has_parted = has_parted || (!was_spent && bond.is_spent());
  }
  return has_parted;
}

/// Keeps the forces that hold bodies, and those of contacts.
void Motion::keep_forces(const Eigen::VectorXd& all, const Eigen::VectorXd& of_contacts) {
  m_.holding.assign(now_.size(), Vec6::Zero());
  m_.meeting.clear();
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (scene_.bodies[b].is_held) m_.holding[b] = of_body(all, b);
    m_.meeting.emplace_back(of_body(of_contacts, b));
  }
}

/// Commits a step.
void Motion::accept(Try step) {
  bounce(step);
  m_.slid = !step.found.slides.empty();
  m_.sliders = std::move(step.found.contacts);
  num_meetings_ = step.found.num_meetings;
  const bool has_parted = crack(step.found);
  const MotionLedger& entry = step.entry;
  m_.ledger.external += entry.external;
  m_.ledger.friction += entry.friction;
  m_.ledger.fracture += entry.fracture;
  for (std::size_t i = 0; i < entry.fracture_of.size(); ++i) m_.ledger.fracture_of[i] += entry.fracture_of[i];
  m_.ledger.damping += entry.damping;
  m_.ledger.impact += entry.impact;
  m_.ledger.numerical += entry.numerical;
  m_.ledger.error += entry.error;
  m_.ledger.kinetic = entry.kinetic;
  m_.ledger.stored = entry.stored;
  keep_forces(step.found.forces, step.found.meeting);
  m_.courses = std::move(step.courses);
  now_ = std::move(step.found.poses);
  m_.time += m_.dt.now;
  m_.dt.before = m_.dt.now;
  m_.dt.begins = false;
  ++m_.easy;
  m_.tears = entry.fracture > 0;
  if (has_parted || !m_.is_released) {
    release();
    StoredEnergies left = stored(m_.courses);
    left.friction = m_.ledger.stored.friction;  // of sliders, which are the next step's to make again
    left.impacts = m_.ledger.stored.impacts;
    m_.ledger.numerical -= left.sum() - m_.ledger.stored.sum();
    m_.ledger.stored = left;
  }
  potential_->begin(now_);
}

void Motion::judge() {
  constexpr double hardly = 1e-6, slow = 1e-3;
  m_.most_kinetic = std::max(m_.most_kinetic, m_.ledger.kinetic);
  bool moves = m_.ledger.kinetic > hardly * m_.most_kinetic || m_.slid;
  for (std::size_t b = 0; b < now_.size() && !moves; ++b)
    if (!scene_.bodies[b].is_held)
      moves = (centre_of(now_[b]) - centre_of(m_.courses[b].before)).norm() >
              slow * std::min(m_.dt.before, natural_) * std::sqrt(pull_ * scene_.bodies[b].size);
  m_.still = moves ? 0 : m_.still + 1;
  end_if_due();
}

/// Whether what is driven has still to move: looked for step by step ahead, up to where it does.
bool Motion::is_driven_on() {
  constexpr double hardly = 1e-9;  // of the structure's smallest body
  if (m_.time < driven_at_) return true;
  double size = std::numeric_limits<double>::infinity();
  for (const MovingBody& body : scene_.bodies) size = std::min(size, body.size);
  for (const Drive& drive : scene_.drives) {
    const double here = drive.displacement->at(m_.time);
    for (double time = m_.time + natural_; time < course_.time; time += natural_)
      if (std::abs(drive.displacement->at(time) - here) > hardly * size) {
        driven_at_ = time;
        return true;
      }
  }
  return false;
}

void Motion::end_if_due() {
  constexpr int enough = 20;
  if (course_.stops_at_rest && m_.still >= enough && !is_driven_on()) {
    ending_ = Ending::at_rest;
    reason_ = fmt::format("at rest after {:.4g}", m_.time);
  } else if (course_.time > 0 && m_.time >= course_.time * (1 - 1e-12)) {
    ending_ = Ending::at_time;
    reason_ = fmt::format("the time {:g} is reached", course_.time);
  }
}

}  // namespace dda
