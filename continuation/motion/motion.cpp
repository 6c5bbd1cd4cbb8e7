#include "continuation/motion/motion.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace dda {
namespace {

constexpr double of_tearing = 0.1;  // of the step, while joints tear
constexpr double inf = std::numeric_limits<double>::infinity();

/// ½ |y − x|²_M of all that moves.
double kinetic(const MovingScene& scene, const Poses& x, const Poses& y, double dt) {
  double out = 0;
  for (std::size_t b = 0; b < x.size(); ++b) {
    if (scene.bodies[b].is_held) continue;
    const Vec6 w = (y[b] - x[b]) / dt;
    out += w.dot(scene.bodies[b].block.times_mass(w)) / 2;
  }
  return out;
}

double dot(const Eigen::VectorXd& forces, const Poses& way) {
  double out = 0;
  for (std::size_t b = 0; b < way.size(); ++b) out += of_body(forces, b).dot(way[b]);
  return out;
}

using Pairs = std::vector<MeetingSearch::Pair>;

/// Adds to `joined` all pairs of some bodies that a chain of bonded ones, in order, connects.
void join_chains(const std::vector<std::uint32_t>& bodies, const Pairs& bonded, Pairs& joined) {
  std::vector<std::size_t> chain(bodies.size());
  std::iota(chain.begin(), chain.end(), std::size_t{0});
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size(); ++b) {
      const auto pair = std::minmax(bodies[a], bodies[b]);
      if (!std::ranges::binary_search(bonded, MeetingSearch::Pair(pair))) continue;
      const std::size_t from = chain[b], to = chain[a];
      std::ranges::replace(chain, from, to);
    }
  for (std::size_t a = 0; a < bodies.size(); ++a)
    for (std::size_t b = a + 1; b < bodies.size(); ++b)
      if (chain[a] == chain[b]) joined.push_back(std::minmax(bodies[a], bodies[b]));
}

MeetingSearch::Pair pair_of(const Bond& bond) {
  return std::minmax(static_cast<std::uint32_t>(bond.first), static_cast<std::uint32_t>(bond.second));
}

void sort(Pairs& pairs) {
  std::ranges::sort(pairs);
  pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
}

}  // namespace

Motion::Motion(const MovingScene& scene, std::vector<Bond> bonds, Poses poses, Poses velocities,
               const MotionCourse& course)
    : scene_(scene), bonds_(std::move(bonds)), course_(course), now_(std::move(poses)) {
  double size = inf, mass = 0, pull = scene.gravity.norm();
  Vec2 load = Vec2::Zero();
  for (std::size_t b = 0; b < scene.num_bodies(); ++b) {
    if (scene.bodies[b].is_held) continue;
    size = std::min(size, scene.bodies[b].size);
    mass += scene.bodies[b].block.mass;
    load += scene.load_on(b).head<2>();
    pull = std::max(pull, centre_of(velocities[b]).squaredNorm() / scene.bodies[b].size);
  }
  pull = std::max(pull, load.norm() / mass);
  natural_ = course_.step * std::sqrt(size / pull);
  if (!std::isfinite(natural_)) natural_ = course_.time > 0 ? course_.time / 1000 : 1;
  dt_ = {natural_, natural_, true};
  tears_ = std::ranges::any_of(bonds_, [](const Bond& bond) { return bond.can_tear() && !bond.is_spent(); });
  before_.resize(now_.size());
  for (std::size_t b = 0; b < now_.size(); ++b) {
    const Pose& w = velocities[b];
    const Mat2 f = gradient_of(now_[b]), rate = gradient_of(w) * f.inverse();
    const double spin = (rate(1, 0) - rate(0, 1)) / 2;
    before_[b] = pose_of(centre_of(now_[b]) - natural_ * centre_of(w), rotation(-natural_ * spin) * f);
  }
  search_ = std::make_unique<MeetingSearch>(scene_, joined_);
  release();
  ledger_.stored = potential_->stored(now_);
  ledger_.kinetic = kinetic(scene_, before_, now_, dt_.before);
}

/// Whether the sides of a spent bond face each other no more.
bool Motion::has_left(const Bond& bond) const {
  constexpr double turn = 0.2, way = 0.1;
  if (!bond.is_spent()) return false;
  const auto angle = [this](std::size_t b) { return polar_of(gradient_of(now_[b])).angle; };
  const Vec2 jump = place_of(now_[bond.second], bond.at_second) - place_of(now_[bond.first], bond.at_first);
  const double size = std::min(scene_.bodies[bond.first].size, scene_.bodies[bond.second].size);
  return std::abs(std::remainder(angle(bond.second) - angle(bond.first), 2 * M_PI)) > turn ||
         jump.norm() > way * size;
}

/// Bodies that a bond joins, or a chain of them around a corner, do not meet. Where the last is spent its law goes on
/// to bear pressure as long as its sides face each other, and until they are apart they do not meet: outlines that have
/// overlapped as bonded bodies may tell no outside.
void Motion::release() {
  Pairs bonded;
  for (const Bond& bond : bonds_)
    if (!bond.is_spent()) bonded.push_back(pair_of(bond));
  sort(bonded);
  Pairs joined = bonded;
  for (const auto& blocks : scene_.around) join_chains(blocks, bonded, joined);
  sort(joined);
  Pairs waiting;
  for (const MeetingSearch::Pair& pair : joined_)
    if (!std::ranges::binary_search(joined, pair) && !search_->are_apart(pair, now_)) waiting.push_back(pair);
  joined.insert(joined.end(), waiting.begin(), waiting.end());
  sort(joined);
  const std::size_t gone = std::erase_if(bonds_, [&](const Bond& bond) {
    return !std::ranges::binary_search(joined, pair_of(bond)) || has_left(bond);
  });
  is_released_ = waiting.empty() && std::ranges::none_of(bonds_, &Bond::is_spent);
  if (potential_ && gone == 0 && joined == joined_) return;
  joined_ = std::move(joined);
  search_ = std::make_unique<MeetingSearch>(scene_, joined_);
  potential_ = std::make_unique<Potential>(scene_, *search_, bonds_);
  solver_ = std::make_unique<StepSolver>(scene_, *potential_, course_.tolerances);
  potential_->begin(now_);
}

Poses Motion::velocities() const {
  Poses out(now_.size());
  for (std::size_t b = 0; b < now_.size(); ++b) out[b] = (now_[b] - before_[b]) / dt_.before;
  return out;
}

/// The longest step that turns no body by more than 0.1 and moves none by more than a fifth of its size.
double Motion::longest() const {
  constexpr double turn = 0.1, way = 0.2;
  double out = natural_ * (tears_ ? of_tearing : 1);
  for (std::size_t b = 0; b < now_.size(); ++b) {
    if (scene_.bodies[b].is_held) continue;
    const double turned = std::abs(std::remainder(
                     polar_of(gradient_of(now_[b])).angle - polar_of(gradient_of(before_[b])).angle,
                     2 * M_PI)),
                 moved = (centre_of(now_[b]) - centre_of(before_[b])).norm();
    if (turned > 0) out = std::min(out, dt_.before * turn / turned);
    if (moved > 0) out = std::min(out, dt_.before * way * scene_.bodies[b].size / moved);
  }
  return out;
}

/// Where bodies fly to in the step; what is held stays.
Poses Motion::flown() const {
  Poses out(now_.size());
  for (std::size_t b = 0; b < now_.size(); ++b)
    out[b] = scene_.bodies[b].is_held ? now_[b] : free_flight(before_[b], now_[b], dt_);
  return out;
}

/// The length of the next step: longer after some that went well, as long as the clock and the end allow.
void Motion::set_step() {
  constexpr double growth = 1.5;
  constexpr int few = 5;
  if (easy_ >= few) {
    dt_.now *= growth;
    easy_ = 0;
  }
  dt_.now = std::min(dt_.now, longest());
  const double left = course_.time - time_;
  if (course_.time > 0 && dt_.now > (1 - 1e-9) * left) dt_.now = left;
}

bool Motion::advance() {
  if (ending_ != Ending::none) return false;
  constexpr double smallest = 1.0 / 4096;
  set_step();
  for (;;) {
    const Poses flight = flown();
    MotionStep step = solver_->solve(now_, flight, dt_, memory_);
    iterations_ += step.iterations;
    if (step.converged()) {
      const MotionLedger entry = book(step, flight);
      const bool is_long = dt_.now > (1 + 1e-9) * of_tearing * natural_;
      if (entry.fracture > 0 && is_long) {
        dt_.now = std::max(of_tearing * natural_, dt_.now / 4);
        easy_ = 0;
        continue;
      }
      if (!creates_energy(entry)) {
        accept(std::move(step), entry);
        judge();
        return true;
      }
      step.failure = fmt::format("the step would create an energy of {:.3g}", -entry.numerical);
    }
    ++rejected_;
    easy_ = 0;
    reason_ = step.failure;
    dt_.now /= 2;
    if (dt_.now < smallest * natural_) {
      ending_ = Ending::failed;
      reason_ = fmt::format("no step of {:.3g} was found: {}", 2 * dt_.now, reason_);
      return false;
    }
  }
}

/// Where the energy of a step has gone.
MotionLedger Motion::book(const MotionStep& step, const Poses& flight) const {
  const double share = dt_.mean() / dt_.now;
  Poses way(now_.size(), Pose::Zero());
  for (std::size_t b = 0; b < now_.size(); ++b) way[b] = (step.poses[b] + flight[b]) / 2 - now_[b];
  double outside = 0, friction = 0, fracture = 0;
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (!scene_.bodies[b].is_held) outside += share * scene_.load_on(b).dot(way[b]);
  for (const Slider& slider : step.sliders) friction += slider.spent(slider.reached(now_, step.poses));
  for (std::size_t i = 0; i < bonds_.size(); ++i)
    fracture += spending(bonds_[i], potential_->state_of(i, step.poses));
  const double inner = share * dot(potential_->gradient(step.poses), way) + outside;
  const double flown = kinetic(scene_, now_, flight, dt_.now);
  MotionLedger out;
  out.stored = potential_->stored(step.poses);
  out.kinetic = kinetic(scene_, now_, step.poses, dt_.now);
  out.external = outside;
  out.fracture = fracture;
  out.friction = friction;
  out.numerical =
      inner - (out.stored.sum() - ledger_.stored.sum()) - out.friction - fracture + (ledger_.kinetic - flown);
  out.error = out.kinetic - flown - (outside - inner);
  return out;
}

/// Whether a step gives back more energy than there was: Newton's method has found another minimum than that beside it.
bool Motion::creates_energy(const MotionLedger& step) const {
  constexpr double bearable = 0.02, hardly = 1e-5;
  double given = 0;  // by the loads to what is free, in one step
  for (std::size_t b = 0; b < now_.size(); ++b)
    if (!scene_.bodies[b].is_held)
      given +=
          dt_.now * dt_.now * scene_.load_on(b).head<2>().squaredNorm() / (2 * scene_.bodies[b].block.mass);
  const double all =
      ledger_.kinetic + step.kinetic + ledger_.stored.sum() + step.stored.sum() + std::abs(step.external);
  return -step.numerical > given + bearable * all + hardly * most_kinetic_;
}

/// What the sliders keep, and whether any has slid.
void Motion::slide(const MotionStep& step) {
  slid_ = false;
  SliderMemory memory;
  for (const Slider& slider : step.sliders) {
    const double u = slider.reached(now_, step.poses);
    slid_ = slid_ || std::abs(u) > (1 + 1e-9) * std::abs(slider.kept(u));
    memory.set(slider.meeting.key, {slider.kept(u), 0});
  }
  const std::vector<Meeting> meetings = potential_->meetings(step.poses);
  num_meetings_ = meetings.size();
  for (const Meeting& meeting : meetings) {
    SliderMemory::Kept kept = memory.of(meeting.key);
    kept.force = response_of(scene_.meeting, meeting).force;
    memory.set(meeting.key, kept);
  }
  memory_ = std::move(memory);
}

/// What the bonds remember; whether one has been spent.
bool Motion::crack(const MotionStep& step) {
  bool has_parted = false;
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    Bond& bond = bonds_[i];
    const bool was_spent = bond.is_spent();
    bond.history =
        bond.law->accept(potential_->state_of(i, step.poses).opening, bond.history, bond.stiffness);
    has_parted = has_parted || (!was_spent && bond.is_spent());
  }
  return has_parted;
}

/// Commits a step.
void Motion::accept(MotionStep step, const MotionLedger& book) {
  slide(step);
  const bool has_parted = crack(step);
  ledger_.external += book.external;
  ledger_.friction += book.friction;
  ledger_.fracture += book.fracture;
  ledger_.numerical += book.numerical;
  ledger_.error += book.error;
  ledger_.kinetic = book.kinetic;
  ledger_.stored = book.stored;
  before_ = std::move(now_);
  now_ = std::move(step.poses);
  time_ += dt_.now;
  dt_.before = dt_.now;
  dt_.begins = false;
  ++easy_;
  tears_ = book.fracture > 0;
  if (has_parted || !is_released_) {
    release();
    ledger_.numerical -= potential_->stored(now_).sum() - ledger_.stored.sum();
    ledger_.stored = potential_->stored(now_);
  }
  potential_->begin(now_);
}

void Motion::judge() {
  constexpr double hardly = 1e-6, slow = 1e-3;
  constexpr int enough = 20;
  most_kinetic_ = std::max(most_kinetic_, ledger_.kinetic);
  bool moves = ledger_.kinetic > hardly * most_kinetic_ || slid_;
  for (std::size_t b = 0; b < now_.size() && !moves; ++b)
    if (!scene_.bodies[b].is_held)
      moves = (centre_of(now_[b]) - centre_of(before_[b])).norm() >
              slow * dt_.before * std::sqrt(scene_.gravity.norm() * scene_.bodies[b].size);
  still_ = moves ? 0 : still_ + 1;
  if (course_.stops_at_rest && still_ >= enough) {
    ending_ = Ending::at_rest;
    reason_ = fmt::format("at rest after {:.4g}", time_);
  } else if (course_.time > 0 && time_ >= course_.time * (1 - 1e-12)) {
    ending_ = Ending::at_time;
    reason_ = fmt::format("the time {:g} is reached", course_.time);
  }
}

}  // namespace dda
