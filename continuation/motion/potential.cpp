#include "continuation/motion/potential.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dda {
namespace {

/// Work of a unit force along `direction` between the vertex and the foot of a meeting: what it is on either body.
std::array<Vec6, 2> rows_along(const Meeting& meeting, const Vec2& direction) {
  return {affine_rows(meeting.at).transpose() * direction,
          -affine_rows(meeting.foot).transpose() * direction};
}

std::array<std::size_t, 2> bodies_of(const Meeting& meeting) { return {meeting.key.body, meeting.key.other}; }

/// The secant of a joint at q: its damage once q has been accepted.
Mat2 secant(const Bond& bond, const Vec2& q) {
  const History then = bond.law->accept(q, bond.history, bond.stiffness);
  const Mat2 out = bond.law->respond_frozen(q, then, bond.stiffness).tangent;
  return (out + out.transpose()) / 2;
}

Mat2 tangent(const Bond& bond, const Vec2& q) {
  const Mat2 out = bond.law->respond(q, bond.history, bond.stiffness).tangent;
  return (out + out.transpose()) / 2;
}

using BlockPairs = std::vector<BlockSum::Pair>;

/// Two bodies as a place below the diagonal, unless one is held.
void add_pair(int i, int j, BlockPairs& out) {
  if (i >= 0 && j >= 0 && i != j)
    out.emplace_back(static_cast<std::uint32_t>(std::max(i, j)), static_cast<std::uint32_t>(std::min(i, j)));
}

}  // namespace

/// Puts matrices of pairs of bodies together; what belongs to held ones pulls at others where these go ways.
class Curvatures {
 public:
  Curvatures(const std::vector<int>& rows, const Poses& ways, BlockSum& sum)
      : rows_(rows),
        ways_(ways),
        sum_(sum),
        pull_(Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(sum.num_rows()))) {
    sum_.set_zero();
  }

  bool wants(std::size_t i, std::size_t j) const {
    return rows_[i] >= 0 && (rows_[j] >= 0 ? rows_[i] >= rows_[j] : !ways_.empty());
  }
  void add(std::size_t i, std::size_t j, const Mat6& m) {
    if (rows_[j] < 0)
      pull_.segment<6>(6 * rows_[i]) += m * ways_[j];
    else
      sum_.add(static_cast<std::size_t>(rows_[i]), static_cast<std::size_t>(rows_[j]), m);
  }
  /// The same with a bᵀ.
  void add(std::size_t i, std::size_t j, const Vec6& a, const Vec6& b) {
    if (rows_[j] < 0)
      pull_.segment<6>(6 * rows_[i]) += a * b.dot(ways_[j]);
    else
      sum_.add(static_cast<std::size_t>(rows_[i]), static_cast<std::size_t>(rows_[j]), a, b);
  }
  /// factor g gᵀ of what counts on two bodies.
  void add(const std::array<std::size_t, 2>& bodies, const std::array<Vec6, 2>& g, double factor) {
    if (factor == 0) return;
    for (std::size_t a = 0; a < 2; ++a) {
      const Vec6 scaled = factor * g[a];
      for (std::size_t b = 0; b < 2; ++b)
        if (wants(bodies[a], bodies[b])) add(bodies[a], bodies[b], scaled, g[b]);
    }
  }
  Eigen::VectorXd take_pull() { return std::move(pull_); }

 private:
  const std::vector<int>& rows_;
  const Poses& ways_;
  BlockSum& sum_;
  Eigen::VectorXd pull_;
};

Potential::Potential(const MovingScene& scene, const MeetingSearch& search, const std::vector<Bond>& bonds)
    : scene_(scene), search_(search), bonds_(bonds) {
  for (const MovingBody& body : scene.bodies)
    rows_.push_back(body.is_held ? -1 : static_cast<int>(num_moving_++));
  for (const Bond& bond : bonds) add_pair(rows_[bond.first], rows_[bond.second], lasting_);
  for (const MotionSpring& spring : scene.springs)
    for (const auto& [i, row_i] : spring.rows)
      for (const auto& [j, row_j] : spring.rows) add_pair(rows_[i], rows_[j], lasting_);
}

/// Makes places for all that may meet. Within a step places only come, so that few orders of elimination are sought; what
/// there was before it does not matter. Whether they are others now.
bool Potential::prepare_pattern() {
  BlockPairs wanted = lasting_;
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
  pairs_ = search_.candidates(start, start);
  frames_.clear();
  for (const Bond& bond : bonds_) frames_.push_back(frame_of(bond, start));
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
    const Vec2 t = bond.law->respond(now.opening, bond.history, bond.stiffness).traction,
               less = now.stress.cwiseQuotient(bond.trial_stiffness());
    for (const auto& [side, b] :
         {std::pair(std::size_t{0}, bond.first), std::pair(std::size_t{1}, bond.second)})
      of_body(out, b) +=
          bond.weight * (now.opening_rows[side].transpose() * t - now.stress_rows[side].transpose() * less);
  }
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
  return out;
}

void Potential::add_bonds(const Poses& at, Softening softening, Curvatures& out) const {
  for (std::size_t i = 0; i < bonds_.size(); ++i) {
    const Bond& bond = bonds_[i];
    const BondState now = state_of(i, at);
    const Mat2 d = softening == Softening::secant ? secant(bond, now.opening) : tangent(bond, now.opening);
    const Vec2 less = bond.trial_stiffness().cwiseInverse();
    const std::array<std::size_t, 2> bodies{bond.first, bond.second};
    for (std::size_t a = 0; a < 2; ++a)
      for (std::size_t b = 0; b < 2; ++b)
        if (out.wants(bodies[a], bodies[b]))
          out.add(bodies[a], bodies[b],
                  bond.weight * (now.opening_rows[a].transpose() * d * now.opening_rows[b] -
                                 now.stress_rows[a].transpose() * less.asDiagonal() * now.stress_rows[b]));
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
  for (const MotionSpring& spring : scene_.springs)
    for (const auto& [i, row_i] : spring.rows)
      for (const auto& [j, row_j] : spring.rows)
        if (out.wants(i, j)) out.add(i, j, spring.stiffness * row_i * row_j.transpose());
  add_bonds(at, softening, out);
  add_clamped(at, out);
  return {sum_.matrix(), clamped_, out.take_pull(), has_new_pattern};
}

std::vector<double> Potential::rounding(const Poses& at, double per_square_time) const {
  constexpr double epsilon = 4 * std::numeric_limits<double>::epsilon();
  std::vector<double> out;
  for (std::size_t b = 0; b < scene_.num_bodies(); ++b) {
    const MovingBody& body = scene_.bodies[b];
    out.push_back(body.block.volume * body.block.stiffness.maxCoeff() / body.size +
                  per_square_time * body.block.mass * centre_of(at[b]).norm());
  }
  const auto add = [&](const std::array<std::size_t, 2>& bodies, double stiffness) {
    const double places = centre_of(at[bodies[0]]).norm() + centre_of(at[bodies[1]]).norm();
    for (const std::size_t b : bodies) out[b] += stiffness * places;
  };
  for (const MotionSpring& spring : scene_.springs) {
    double sum = std::abs(spring.length);
    for (const auto& [b, row] : spring.rows) sum += row.cwiseAbs().dot(at[b].cwiseAbs());
    for (const auto& [b, row] : spring.rows) out[b] += spring.stiffness * row.head<2>().norm() * sum;
  }
  for (const Bond& bond : bonds_)
    add({bond.first, bond.second}, bond.weight * bond.trial_stiffness().maxCoeff());
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
