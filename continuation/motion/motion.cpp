#include "continuation/motion/motion.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "continuation/motion/motion_try.hpp"
#include "continuation/motion/step/open_close_step.hpp"
#include "continuation/motion/step/step_minimum.hpp"

namespace dda {
namespace {

constexpr double of_tearing = 0.1;  // of the step, while joints tear
constexpr double inf = std::numeric_limits<double>::infinity();

/// How much of a force is still there, 1 where nothing has changed and 0 where it has halved, doubled or turned round.
double share_that_lasts(const Vec2& before, const Vec2& now) {
  const double square = before.squaredNorm();
  if (!(square > 0)) return 0;
  const double along = before.dot(now) / square;
  return std::clamp(2 * std::min(1.0, along) - std::max(1.0, along), 0.0, 1.0);
}

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
  search_ = std::make_unique<MeetingSearch>(scene_, m_.joined);
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

/// The longest step that turns no body by more than 0.1, moves none by more than a fifth of its size, and no corner by more
/// than most of what the solver bears.
double Motion::longest() const {
  constexpr double turn = 0.1, way = 0.2, most = 0.8;
  constexpr double without_inertia = 1e3;  // no motion is missed by a step that is long
  double out = natural_ * (m_.tears ? of_tearing : course_.integrator->has_inertia() ? 1 : without_inertia);
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (scene_.bodies[b].is_held) continue;
    const Pose& before = m_.courses[b].before;
    const double turned = std::abs(std::remainder(
                     polar_of(gradient_of(now_[b])).angle - polar_of(gradient_of(before)).angle, 2 * M_PI)),
                 moved = (centre_of(now_[b]) - centre_of(before)).norm();
    if (turned > 0) out = std::min(out, m_.dt.before * turn / turned);
    if (moved > 0) out = std::min(out, m_.dt.before * way * scene_.bodies[b].size / moved);
    if (const double all = travelled(b, turned); solver_->longest_way() > 0 && all > 0)
      out = std::min(out, m_.dt.before * most * solver_->longest_way() / all);
  }
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
  constexpr int few = 5;
  if (m_.easy >= few) {
    m_.dt.now *= growth;
    m_.easy = 0;
  }
  m_.dt.now = std::min(m_.dt.now, longest());
  const double left = course_.time - m_.time;
  if (course_.time > 0 && m_.dt.now > (1 - 1e-9) * left) m_.dt.now = left;
}

Motion::Try Motion::try_step() {
  Try out{aim(), {}};
  potential_->set_damped({velocities(), m_.dt.now, course_.integrator->end_rate()});
  out.found = solver_->solve({now_, m_.courses, m_.sliders}, out.inertia);
  m_.iterations += out.found.iterations;
  if (!out.found.converged()) return out;
  book(out);
  if (creates_energy(out))
    out.found.failure = fmt::format("the step would create an energy of {:.3g}", -out.entry.numerical);
  return out;
}

bool Motion::advance() {
  if (ending_ != Ending::none) return false;
  constexpr double smallest = 1.0 / 4096;
  set_step();
  for (;;) {
    Try step = try_step();
    const bool is_long = m_.dt.now > (1 + 1e-9) * of_tearing * natural_;
    if (step.entry.fracture > 0 && is_long) {
      m_.dt.now = std::max(of_tearing * natural_, m_.dt.now / 4);
      m_.easy = 0;
      continue;
    }
    if (step.found.converged()) {
      accept(std::move(step));
      judge();
      return true;
    }
    ++m_.rejected;
    m_.easy = 0;
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

/// What is stored where the velocities are told of. Where they are means over the last step, the strain of bodies that nothing
/// holds follows their loads and is that of the middle; what vibrates in joints goes with the velocity of an implicit step,
/// which is that of the end.
StoredEnergies Motion::stored(const std::vector<BodyCourse>& at) const {
  StoredEnergies out = solver_->stored(at);
  if (!course_.integrator->has_mean_velocities()) return out;
  for (std::size_t b = 0; b < at.size(); ++b) {
    const AffineBlock& block = scene_.bodies[b].block;
    if (scene_.bodies[b].is_held || joined_.is_joined(b)) continue;
    const Vec3 before = green_strain(at[b].before), now = green_strain(at[b].now);
    out.strain += strain_energy_of(block, (before + now) / 2) - strain_energy_of(block, now);
  }
  return out;
}

/// By body, in a step.
std::vector<AsOne> Motion::as_one(const Try& step) const {
  std::vector<Pose> accelerations;
  for (std::size_t b = 0; b < now_.size(); ++b)
    accelerations.push_back(step.inertia.per_square_time * (step.found.poses[b] - step.inertia.flight[b]));
  return joined_.as_one(m_.courses, accelerations, step.found.poses);
}

/// A driven body works on its way as one that flies does.
BodyStep Motion::step_of(std::size_t body, const Try& step, const AsOne& as_one) const {
  const AffineBlock& block = scene_.bodies[body].block;
  const BodyCourse& start = m_.courses[body];
  BodyStep out{.start = start,
               .flight = step.inertia.flight[body],
               .reached = step.found.poses[body],
               .dt = m_.dt,
               .as_one = as_one};
  if (!scene_.bodies[body].is_held) {
    out.gyration = std::sqrt(block.inertia.trace() / block.mass);
    out.is_joined = joined_.is_joined(body);
    out.lasts = share_that_lasts(start.steady.velocity - as_one.pull, as_one.now - as_one.pull);
  } else {
    out.flight = now_[body] + m_.dt.now * start.velocity;
    out.lasts =
        share_that_lasts(m_.holding[body].head<2>(), of_body(step.found.forces, body).template head<2>());
  }
  if (m_.dt.begins) out.lasts = 0;
  return out;
}

/// Where the energy of a step has gone, and the courses it would lead to.
void Motion::book(Try& step) const {
  const Poses& reached = step.found.poses;
  MotionLedger& out = step.entry;
  const std::vector<AsOne> all = as_one(step);
  const double end = course_.integrator->share_of_end();
  double inner = 0, of_start = 0;
  Poses beyond(now_.size());
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    const BodyStep of = step_of(b, step, all[b]);
    step.courses.push_back(course_.integrator->arrive(of));
    const BodyWork work = course_.integrator->work(body.block, of);
    beyond[b] = work.rubbed - (reached[b] - now_[b]);
    const auto forces = of_body(step.found.forces, b);
    if (body.is_held) {
      const double driven = (end * forces + (1 - end) * m_.holding[b]).dot(work.rubbed);
      step.courses[b].velocity = (reached[b] - now_[b]) / m_.dt.now;
      out.external += driven;
      inner += driven;
      continue;
    }
    const Pose loaded = reached[b] - step.courses[b].lag - (now_[b] - m_.courses[b].lag);
    out.external += scene_.load_on(b).dot(loaded);
    inner += scene_.load_on(b).dot(loaded) + forces.dot(work.way);
    step.flown += work.flown;
    of_start += work.of_start;
    out.kinetic += kinetic_energy(body.block, step.courses[b].velocity);
  }
  for (const Slide& slide : step.found.slides) out.friction += slide.spent_on_way(beyond);
  out.fracture_of.assign(m_.ledger.fracture_of.size(), 0);
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const double spent = spending(bonds_[i], potential_->state_of(i, reached));
    out.fracture += spent;
    if (bonds_[i].interface >= 0) out.fracture_of[static_cast<std::size_t>(bonds_[i].interface)] += spent;
  }
  out.damping = potential_->spent_by_damping(reached);
  out.stored = stored(step.courses);
  out.stored.impacts = m_.ledger.stored.impacts;
  out.numerical = inner - of_start - (out.stored.sum() - m_.ledger.stored.sum()) - out.friction -
                  out.fracture - out.damping + (m_.ledger.kinetic - step.flown);
  out.error = out.external - inner + of_start - (out.kinetic - step.flown);
}

/// Whether a step gives back more energy than there was: Newton's method has found another minimum than that beside it.
bool Motion::creates_energy(const Try& tried) const {
  constexpr double bearable = 0.02, hardly = 1e-5;
  if (!solver_->loses_energy()) return false;
  const MotionLedger& step = tried.entry;
  double given = 0;  // by the loads to what is free, in one step, and by what is driven in its second half
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (!scene_.bodies[b].is_held)
      given += m_.dt.now * m_.dt.now * scene_.load_on(b).head<2>().squaredNorm() /
               (2 * scene_.bodies[b].block.mass);
    else
      given += std::max(0.0, of_body(tried.found.forces, b).dot(tried.found.poses[b] - now_[b])) / 2;
  const double all = m_.ledger.kinetic + step.kinetic + std::abs(m_.ledger.stored.sum()) +
                     std::abs(step.stored.sum()) + std::abs(step.external);
  const double ahead = step.fracture + step.damping;  // booked up to half a step before that work
  const double made = -step.numerical - given - ahead - bearable * all - hardly * m_.most_kinetic;
  if (made <= 0 || m_.dt.now >= m_.dt.before || m_.dt.begins) return made > 0;
  // A shorter step than the last one begins nearer to its end than to its middle, of which the energies are.
  double since_middle = solver_->stored(m_.courses).sum() + m_.ledger.stored.impacts -
                        m_.ledger.stored.sum() + tried.flown - m_.ledger.kinetic;
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (!scene_.bodies[b].is_held) since_middle -= scene_.load_on(b).dot(m_.courses[b].lag);
  return made > (1 - m_.dt.now / m_.dt.before) * std::max(0.0, since_middle);
}

/// What the bonds remember; whether one has been spent. A corner that is pressed may never tear: bodies that have turned over it
/// so far that other sides of theirs may meet are held by it no longer.
bool Motion::crack(const MotionStep& step) {
  constexpr double over = 0.7;
  bool has_parted = false;
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

/// Keeps the forces that hold bodies.
void Motion::hold_by(const Eigen::VectorXd& forces) {
  m_.holding.assign(now_.size(), Vec6::Zero());
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (scene_.bodies[b].is_held) m_.holding[b] = of_body(forces, b);
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
  m_.ledger.numerical += entry.numerical;
  m_.ledger.error += entry.error;
  m_.ledger.kinetic = entry.kinetic;
  m_.ledger.stored = entry.stored;
  hold_by(step.found.forces);
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
