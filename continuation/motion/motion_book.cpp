// Where the energy of a step has gone.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "continuation/motion/motion_try.hpp"

namespace dda {
namespace {

/// How much of a force is still there, 1 where nothing has changed and 0 where it has halved, doubled or turned round.
double share_that_lasts(const Vec2& before, const Vec2& now) {
  const double square = before.squaredNorm();
  if (!(square > 0)) return 0;
  const double along = before.dot(now) / square;
  return std::clamp(2 * std::min(1.0, along) - std::max(1.0, along), 0.0, 1.0);
}

/// Whether no force that a body bore counts in its next step: those of an impact that is over are used up.
bool is_anew(const MovingBody& body, const BodyCourse& course) {
  return !body.is_held && course.acceleration.isZero(0);
}

/// What has slid, without the forces at the start that are used up.
std::vector<Slide> as_they_count(std::vector<Slide> slides, const MovingScene& scene,
                                 const std::vector<BodyCourse>& from) {
  for (Slide& slide : slides)
    for (const std::size_t b : bodies_of(slide.meeting))
      if (is_anew(scene.bodies[b], from[b])) slide.at_start = 0;
  return slides;
}

}  // namespace

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

void Motion::book_fracture(const Poses& reached, MotionLedger& out) const {
  out.fracture_of.assign(m_.ledger.fracture_of.size(), 0);
  const auto add = [&](std::size_t bond, double spent) {
    const int interface = bonds_[bond].interface;
    out.fracture += spent;
    if (interface >= 0) out.fracture_of[static_cast<std::size_t>(interface)] += spent;
  };
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    add(i, spending(bonds_[i], potential_->state_of(i, reached)));
  for (const GivenUp& lost : given_up_) add(lost.bond, lost.energy);
}

/// What contacts take from a body in a step, along the way on which they rub it [F L].
double Motion::done_by_contacts(std::size_t body, const Try& step, const BodyWork& work) const {
  const double end = course_.integrator->share_of_end();
  const bool is_in_first_order = !scene_.bodies[body].is_held && course_.integrator->open_close();
  const Pose way = is_in_first_order ? work.way : Pose(end * work.rubbed);
  const bool counts = !m_.meeting.empty() && !is_anew(scene_.bodies[body], m_.courses[body]);
  const double before = counts ? m_.meeting[body].dot(work.rubbed) : 0;
  return of_body(step.found.meeting, body).dot(way) + (1 - end) * before;
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
    out.impact += done_by_contacts(b, step, work);
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
  for (const Slide& slide : as_they_count(step.found.slides, scene_, m_.courses))
    out.friction += slide.spent_on_way(beyond, end);
  book_fracture(reached, out);
  out.damping = potential_->spent_by_damping(reached);
  out.stored = stored(step.courses);
  out.stored.impacts = m_.ledger.stored.impacts;
  out.impact -= out.stored.of_contacts() - m_.ledger.stored.of_contacts() + out.friction;
  out.numerical = inner - of_start - (out.stored.sum() - m_.ledger.stored.sum()) - out.friction -
                  out.fracture - out.damping + (m_.ledger.kinetic - step.flown) - out.impact;
  out.error = out.external - inner + of_start - (out.kinetic - step.flown);
}

/// The largest error of a place over the one that is allowed, in sizes of its body: ½ dt² |ÿ₁ − ÿ₀| of rigid motions, what an
/// acceleration that changes somewhere in the step leaves open. 0 where none is asked for.
double Motion::error_of(const Try& step) const {
  if (!course_.accuracy || m_.dt.begins) return 0;
  double most = 0;
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    if (body.is_held) continue;
    const RigidMotion before = rigid_part(now_[b], m_.courses[b].acceleration),
                      after = rigid_part(step.found.poses[b], step.courses[b].acceleration);
    most = std::max(
        {most, (after.velocity - before.velocity).norm() / body.size, std::abs(after.spin - before.spin)});
  }
  return m_.dt.now * m_.dt.now / 2 * most / *course_.accuracy;
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
  const double made = -step.lost() - given - ahead - bearable * all - hardly * m_.most_kinetic;
  if (made <= 0 || m_.dt.now >= m_.dt.before || m_.dt.begins) return made > 0;
  // A shorter step than the last one begins nearer to its end than to its middle, of which the energies are.
  double since_middle = solver_->stored(m_.courses).sum() + m_.ledger.stored.impacts -
                        m_.ledger.stored.sum() + tried.flown - m_.ledger.kinetic;
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (!scene_.bodies[b].is_held) since_middle -= scene_.load_on(b).dot(m_.courses[b].lag);
  return made > (1 - m_.dt.now / m_.dt.before) * std::max(0.0, since_middle);
}

}  // namespace dda
