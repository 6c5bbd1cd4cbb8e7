#include "continuation/motion/energy/clamped_springs.hpp"

#include <Eigen/LU>
#include <tuple>
#include <utility>

#include "framework/base/threads.hpp"

namespace dda {
namespace {

using State = ClampedSpring::State;

/// A state's line: the force where nothing is stretched, and what it grows by with the stretch.
struct Line {
  double offset, slope;

  double at(double x) const { return offset + slope * x; }
};

Line line_of(const ClampedSpring& spring, State state) {
  if (state == State::within) return {spring.stiffness * spring.at, spring.stiffness};
  return {state == State::low ? spring.low : spring.high, 0};
}

}  // namespace

ClampedMinimum::ClampedMinimum(const PositiveFactor& factor, const std::vector<ClampedSpring>& springs,
                               Eigen::Index most)
    : factor_(factor), springs_(springs), most_(most), is_changed_(springs.size(), false) {
  first_.reserve(springs.size());
  for (const ClampedSpring& spring : springs) first_.push_back(spring.state(0));
}

double ClampedMinimum::stretch_of(std::size_t spring, Eigen::Ref<const Vector> dz) const {
  const auto& [rows, along] = std::tie(springs_[spring].rows, springs_[spring].along);
  double out = 0;
  for (std::size_t side = 0; side < 2; ++side)
    if (rows[side] >= 0) out += along[side].dot(dz.segment<6>(6 * rows[side]));
  return out;
}

ClampedMinimum::Vector ClampedMinimum::stretches_of(const Vector& dz) const {
  Vector out(static_cast<Eigen::Index>(springs_.size()));
  parallel_for(springs_.size(), 4096,
               [&](std::size_t e) { out[static_cast<Eigen::Index>(e)] = stretch_of(e, dz); });
  return out;
}

/// Whether these are few enough to go on with.
bool ClampedMinimum::include_changed(const Vector& x) {
  const auto old = static_cast<Eigen::Index>(changed_.size());
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    if (is_changed_[e] || springs_[e].state(x[static_cast<Eigen::Index>(e)]) == first_[e]) continue;
    is_changed_[e] = true;
    changed_.push_back(e);
  }
  const auto now = static_cast<Eigen::Index>(changed_.size());
  if (now > most_) return false;
  if (now == old) return true;
  add_halves();
  stretches_.conservativeResize(now, now);
  parallel_for(static_cast<std::size_t>(now - old), 4, [&](std::size_t i) {
    const Eigen::Index c = old + static_cast<Eigen::Index>(i);
    const PositiveFactor::Half& half = halves_[static_cast<std::size_t>(c)];
    for (Eigen::Index r = 0; r <= c; ++r)
      stretches_(r, c) = stretches_(c, r) = half.dot(halves_[static_cast<std::size_t>(r)]);
  });
  return true;
}

/// Of the changed springs that have none yet.
void ClampedMinimum::add_halves() {
  const std::size_t old = halves_.size();
  halves_.resize(changed_.size());
  parallel_for(changed_.size() - old, 4, [&](std::size_t i) {
    const ClampedSpring& spring = springs_[changed_[old + i]];
    Vector unit = Vector::Zero(factor_.num_rows());
    for (std::size_t side = 0; side < 2; ++side)
      if (const int row = spring.rows[side]; row >= 0) unit.segment<6>(6 * row) += spring.along[side];
    halves_[old + i] = factor_.half_of(unit);
  });
}

/// A⁻¹ of forces of the changed springs.
ClampedMinimum::Vector ClampedMinimum::way_by(const Vector& forces) const {
  Vector sum = Vector::Zero(factor_.num_rows());
  for (std::size_t c = 0; c < halves_.size(); ++c)
    halves_[c].add_to(sum, forces[static_cast<Eigen::Index>(c)]);
  return factor_.other_half_of(std::move(sum));
}

/// What the changed springs bear beyond their first line where all are in the states they have at x.
ClampedMinimum::Vector ClampedMinimum::forces_for(const Vector& x) const {
  const auto m = static_cast<Eigen::Index>(changed_.size());
  Vector offset(m), slope(m);
  for (Eigen::Index c = 0; c < m; ++c) {
    const std::size_t e = changed_[static_cast<std::size_t>(c)];
    const Line then = line_of(springs_[e], springs_[e].state(x[static_cast<Eigen::Index>(e)])),
               first = line_of(springs_[e], first_[e]);
    offset[c] = then.offset - first.offset;
    slope[c] = then.slope - first.slope;
  }
  const auto reduced = stretches_.topLeftCorner(m, m);
  const Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(m, m) + reduced * slope.asDiagonal();
  const Vector stretch = matrix.partialPivLu().solve(of_changed(unchanged_) - reduced * offset);
  return offset + slope.cwiseProduct(stretch);
}

ClampedMinimum::Vector ClampedMinimum::of_changed(const Vector& all) const {
  Vector out(static_cast<Eigen::Index>(changed_.size()));
  for (std::size_t c = 0; c < changed_.size(); ++c)
    out[static_cast<Eigen::Index>(c)] = all[static_cast<Eigen::Index>(changed_[c])];
  return out;
}

bool ClampedMinimum::has_states_of(const Vector& x, const Vector& other) const {
  for (std::size_t e = 0; e < springs_.size(); ++e)
    if (springs_[e].state(x[static_cast<Eigen::Index>(e)]) !=
        springs_[e].state(other[static_cast<Eigen::Index>(e)]))
      return false;
  return true;
}

/// Where along a way the function is least, at most all of it; what does not come from changes of state is
/// quadratic[0] + share · quadratic[1].
double ClampedMinimum::share_of_way(const Vector& x, const Vector& way,
                                    const std::array<double, 2>& quadratic) const {
  constexpr int most = 60;
  std::vector<std::size_t> counting;  // a spring whose state is the first at both ends has it all the way
  for (std::size_t e = 0; e < springs_.size(); ++e) {
    const auto at = static_cast<Eigen::Index>(e);
    if (springs_[e].state(x[at]) != first_[e] || springs_[e].state(x[at] + way[at]) != first_[e])
      counting.push_back(e);
  }
  const auto slope_at = [&](double share) {
    double out = quadratic[0] + share * quadratic[1];
    for (const std::size_t e : counting) {
      const auto at = static_cast<Eigen::Index>(e);
      const double stretch = x[at] + share * way[at];
      if (springs_[e].state(stretch) != first_[e])
        out += way[at] * (springs_[e].force(stretch) - line_of(springs_[e], first_[e]).at(stretch));
    }
    return out;
  };
  double low = 0, high = 1, at_low = slope_at(0), at_high = slope_at(1);
  const double enough = 1e-3 * std::abs(at_low);
  if (!(at_high > enough)) return 1;
  for (int i = 0; i < most; ++i) {
    const double share = i % 3 == 2 ? (low + high) / 2 : low - at_low * (high - low) / (at_high - at_low),
                 now = slope_at(share);
    if (std::abs(now) <= enough) return share;
    (now > 0 ? high : low) = share;
    (now > 0 ? at_high : at_low) = now;
  }
  return low > 0 ? low : high;
}

/// dz = share · A⁻¹ b − A⁻¹ Σ forces, from dz = 0 on.
Eigen::VectorXd ClampedMinimum::solve(const Eigen::VectorXd& b) {
  constexpr int most = 100;
  const Vector plain = factor_.solve(b);
  const double plain_work = plain.dot(b);
  unchanged_ = stretches_of(plain);
  Vector x = Vector::Zero(unchanged_.size()), forces;
  const auto end_of = [&](double share) {
    return forces.size() == 0 ? Vector(share * plain) : Vector(share * plain - way_by(forces));
  };
  double share = 0;
  for (int i = 0; i < most && include_changed(x); ++i) {
    forces.conservativeResizeLike(Vector::Zero(static_cast<Eigen::Index>(changed_.size())));
    const Vector before = std::exchange(forces, forces_for(x)), goal = forces;
    Vector end = end_of(1);
    const Vector there = stretches_of(end), way = there - x, pull = of_changed(way);
    const double work = (1 - share) * plain_work - of_changed(unchanged_).dot(goal - before);
    const double step = share_of_way(
        x, way, {(share - 1) * work - pull.dot(before), (1 - share) * work - pull.dot(goal - before)});
    if (step == 1 && has_states_of(x, there)) return end;
    forces = before + step * (goal - before);
    share += step * (1 - share);
    x += step * way;
  }
  return end_of(share);
}

}  // namespace dda
