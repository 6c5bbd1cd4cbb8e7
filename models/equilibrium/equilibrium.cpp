#include "models/equilibrium/equilibrium.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "framework/base/threads.hpp"
#include "models/equilibrium/loading.hpp"
#include "models/kinematics/second_order.hpp"

namespace dda {
namespace {

double extent_of(const Assembly& assembly) {
  Eigen::AlignedBox2d box;
  for (const Block& block : assembly.blocks)
    for (const Vec2& x : block.outline.vertices) box.extend(x);
  return box.diagonal().norm();
}

constexpr std::size_t parts_at_once = 4000;  // blocks or points

std::vector<std::pair<BlockId, BlockId>> touching_blocks(const Body& body) {
  std::vector<std::pair<BlockId, BlockId>> pairs;
  for (const Side& side : body.assembly.sides) pairs.emplace_back(side.first, side.second);
  return pairs;
}

/// Blocks that one load or gauge spring ties together (a driven mean of several blocks) also share matrix
/// entries.
void add_pairs(const std::vector<Spring>& springs, std::vector<std::pair<BlockId, BlockId>>& pairs) {
  for (const Spring& spring : springs)
    for (const auto& [a, row_a] : spring.displacement.rows)
      for (const auto& [b, row_b] : spring.displacement.rows)
        if (a < b) pairs.emplace_back(a, b);
}

/// Nodes that a point ties to each other beside its blocks.
void add_pairs(const InterfacePoint& point, std::vector<std::pair<BlockId, BlockId>>& pairs) {
  if (point.multiplier == Multiplier::unknown && point.column == 0) {
    pairs.emplace_back(point.first, point.node);
    pairs.emplace_back(point.second, point.node);
  }
  const auto add_with = [&](BlockId other) {
    point.for_each_part([&](BlockId node, const Mat26&) { pairs.emplace_back(node, other); });
  };
  for (const GradientRows& gradient : point.gradients) add_with(gradient.node);
  for (const JumpRows& jump : point.jumps) add_with(jump.node);
}

/// Adds [rows]ᵀ diag(p) [rows] of every part of a point with every other.
void add_joint(BlockMatrix& matrix, const InterfacePoint& point, const Vec2& p) {
  point.for_each_part([&](BlockId a, const Mat26& left) {
    point.for_each_part(
        [&](BlockId b, const Mat26& right) { matrix.add(a, b, left.transpose() * p.asDiagonal() * right); });
  });
}

/// Adds a multiple of the energy that a consistent joint subtracts, ½ W {σ}n·P⁻¹{σ}n.
void add_stress_energy(BlockMatrix& matrix, const InterfacePoint& point, double factor) {
  if (!point.has_stresses()) return;
  const Vec2 p = factor * point.weight * point.trial_stiffness().cwiseInverse();
  point.for_each_stress([&](BlockId a, const Mat26& left) {
    point.for_each_stress([&](BlockId b, const Mat26& right) {
      const Mat26 forces = p.asDiagonal() * right;
      matrix.add(a, b, left.transpose() * forces);
    });
  });
}

/// Adds −(1 + δ) W P of an unknown multiplier.
void subtract_multiplier_energy(BlockMatrix& matrix, const InterfacePoint& point) {
  if (point.multiplier != Multiplier::unknown) return;
  const Mat26 rows = point.multiplier_rows();
  const Vec2 p = -(1 + point.perturbation) * point.weight * point.trial_stiffness();
  matrix.add(point.node, point.node, rows.transpose() * p.asDiagonal() * rows);
}

/// Whether two matrices have the same first rows and columns; what they couple with further ones is another matter.
bool are_same(const BlockMatrix& a, const BlockMatrix& b, std::size_t num_rows) {
  constexpr double rounding = 1e-13;
  const auto end_of = [num_rows](const BlockMatrix& m, std::size_t row) {
    const auto first = m.columns().begin(), start = first + static_cast<std::ptrdiff_t>(m.row_start()[row]),
               end = first + static_cast<std::ptrdiff_t>(m.row_start()[row + 1]);
    return static_cast<std::size_t>(std::lower_bound(start, end, num_rows) - first);
  };
  return 0 == parallel_sum(num_rows, parts_at_once, [&](std::size_t row) -> double {
           std::size_t i = a.row_start()[row], j = b.row_start()[row];
           const std::size_t count = end_of(a, row) - i;
           if (count != end_of(b, row) - j) return 1;
           double size = 0, change = 0;
           for (std::size_t end = i + count; i < end; ++i, ++j) {
             if (a.columns()[i] != b.columns()[j]) return 1;
             size = std::max(size, a.value(i).cwiseAbs().maxCoeff());
             change = std::max(change, (a.value(i) - b.value(j)).cwiseAbs().maxCoeff());
           }
           return change <= rounding * size ? 0 : 1;
         });
}

Mat6 stiffness_of_gradient(const Body& body, BlockId id) {
  const Moments& moments = body.block(id).moments;
  return body.thickness * gradient_stiffness(body.material(id).stiffness(), moments.second, moments.area);
}

}  // namespace

void add_stress_energy(BlockMatrix& matrix, const InterfacePoint& point) {
  add_stress_energy(matrix, point, 1);
}

Equilibrium::Equilibrium(const Body& body, const ModelParameters& model, StageHistory history,
                         std::optional<InterfaceSet> points)
    : num_blocks_(body.assembly.num_blocks()),
      num_jumps_(body.num_jumps()),
      num_cuts_(body.cracks ? body.cracks->cuts().size() : 0),
      intact_(0, {}),
      history_(std::move(history)),
      num_dead_stages_(model.num_dead_stages()) {
  Findings findings;
  for (const BlockId id : body.second_order.blocks)
    gradients_.push_back({id, stiffness_of_gradient(body, id)});
  set_ = points ? *std::move(points) : make_interface_points(body, model, findings);
  num_unknown_multipliers_ = 2 * static_cast<std::size_t>(std::ranges::count(set_.points, Multiplier::unknown,
                                                                             &InterfacePoint::multiplier));
  const std::size_t num_before = findings.size();
  all_supports_ = make_supports(body, model, findings);
  const LoadProgramme programme = make_loads(body, model, findings);
  driven_ = programme.driven;
  added_ = dda::added_springs(all_supports_, model, findings);
  removed_ = programme.removed(all_supports_);
  check_driven(programme, supports_after(0, removed_.size()), findings);
  const bool are_whole = findings.size() == num_before;  // of springs that are missing nothing can be said
  if (!model.stages.empty() && are_whole) check_supports(body, model, findings);
  for (std::size_t i = 0; i < history_.rest.size(); ++i)
    all_supports_[added_[i].spring].rest = history_.rest[i];
  supports_ = supports_after(history_.rest.size(), history_.borne.size());
  std::vector<Spring> springs = supports_;
  springs.insert(springs.end(), driven_.begin(), driven_.end());
  StageLoadings made =
      make_stages({body, model, set_, all_supports_, supports_, removed_, history_}, programme, findings);
  stages_ = std::move(made.begun);
  later_stages_ = std::move(made.later);
  findings.throw_if_any();
  for (std::size_t i = 0; i < num_blocks_; ++i) block_size_.push_back(body.size(BlockId{i}));
  extent_ = extent_of(body.assembly);
  fit_stages();
  assemble(body, model, springs);
}

bool Equilibrium::remake(const Body& body, const ModelParameters& model) {
  std::optional<InterfaceSet> points;
  if (num_unknown_multipliers_ == 0) {
    Findings findings;
    remake_interface_points(body, model, findings, set_);
    findings.throw_if_any();
    points = std::move(set_);
  }
  Equilibrium made(body, model, history_, std::move(points));
  const bool is_same = are_same(intact_, made.intact_, num_block_nodes());
  std::ranges::move(made.stages_, stages_.begin());
  made.stages_ = std::move(stages_);
  *this = std::move(made);
  return is_same;
}

void Equilibrium::assemble(const Body& body, const ModelParameters& model,
                           const std::vector<Spring>& springs) {
  auto pairs = touching_blocks(body);
  for (std::size_t g = 0; g < body.num_gradients(); ++g)
    pairs.emplace_back(body.second_order.blocks[g], BlockId{num_blocks_ + g});
  add_pairs(springs, pairs);
  for (const InterfacePoint& point : set_.points) add_pairs(point, pairs);
  intact_ = BlockMatrix(num_nodes(), pairs, num_leading());
  weak_stiffness_ = model.weak_springs * body.largest_modulus() * body.thickness;
  add_strain_energy(body);
  for (const Spring& spring : springs) add_spring(spring);
  for (const InterfacePoint& point : set_.points) {
    add_stress_energy(intact_, point, -1);
    subtract_multiplier_energy(intact_, point);
    if (!point.is_separate()) add_joint(intact_, point, point.weight * point.intact_stiffness());
  }
  held_stiffness_ = body.largest_modulus() * body.thickness;
  hold_unused_unknowns();
  join_what_touches();
  estimate_rounding();
}

void Equilibrium::add_strain_energy(const Body& body) {
  for (std::size_t i = 0; i < num_blocks_; ++i) {
    const BlockId id{i};
    strain_stiffness_.push_back(body.volume(id) * body.material(id).stiffness());
    Mat6 k = strain_rows().transpose() * strain_stiffness_.back() * strain_rows();
    k.diagonal().head<3>() += weak_stiffness_ * Vec3(1, 1, body.block(id).moments.area);
    intact_.add(id, id, k);
  }
  for (const Gradient& gradient : gradients_) {
    const BlockId node = *body.gradient_of(gradient.block);
    intact_.add(node, node, gradient.stiffness);
  }
}

void Equilibrium::join_what_touches() {
  if (std::ranges::none_of(set_.points, &InterfacePoint::is_separate)) return;
  unjoined_ = intact_;
  for (const InterfacePoint& point : set_.points)
    if (point.is_separate()) add_joint(intact_, point, point.weight * point.intact_stiffness());
}

void Equilibrium::estimate_rounding() {
  constexpr double few = 4;
  std::vector<double> joined(num_nodes(), 0.0);
  for (const InterfacePoint& point : set_.points)
    point.for_each_part([&](BlockId node, const Mat26&) { ++joined[node.value()]; });
  for (const double n : joined)
    rounding_of_sums_.push_back((few + std::sqrt(n)) * std::numeric_limits<double>::epsilon());
}

/// A node has room for three multipliers, a jump has three unknowns; what nothing uses gets a diagonal of its own.
void Equilibrium::hold_unused_unknowns() {
  constexpr int of_jump = 3;
  std::vector<int> used(num_jumps_, of_jump);
  used.resize(num_jumps_ + set_.num_nodes, 0);
  const std::size_t first = num_block_nodes();
  for (const InterfacePoint& point : set_.points)
    if (point.multiplier == Multiplier::unknown)
      used[point.node.value() - first] = std::max(used[point.node.value() - first], point.column + 2);
  for (std::size_t i = 0; i < used.size(); ++i) {
    const BlockId node{first + i};
    Mat6 rest = Mat6::Zero();
    for (int j = used[i]; j < block_unknowns; ++j) {
      rest(j, j) = held_stiffness_;
      held_.push_back(block_unknowns * node.value() + static_cast<std::size_t>(j));
    }
    intact_.add(node, node, rest);
  }
}

BlockMatrix Equilibrium::unperturbed() const {
  BlockMatrix out = intact_;
  for (const InterfacePoint& point : set_.points) {
    if (point.multiplier != Multiplier::unknown) continue;
    const Mat26 rows = point.multiplier_rows();
    const Vec2 p = point.perturbation * point.weight * point.trial_stiffness();
    out.add(point.node, point.node, rows.transpose() * p.asDiagonal() * rows);
  }
  return out;
}

void Equilibrium::add_spring(const Spring& spring) {
  for (const auto& [a, row_a] : spring.displacement.rows)
    for (const auto& [b, row_b] : spring.displacement.rows)
      intact_.add(a, b, spring.stiffness * row_a * row_b.transpose());
}

Vec2 Equilibrium::opening(std::size_t p, std::span<const double> d) const {
  const InterfacePoint& point = set_.points[p];
  Vec2 out = point.rows.first * Eigen::Map<const Vec6>(d.data() + 6 * point.first.value()) +
             point.rows.second * Eigen::Map<const Vec6>(d.data() + 6 * point.second.value());
  for (const GradientRows& gradient : point.gradients)
    out += gradient.rows * Eigen::Map<const Vec6>(d.data() + 6 * gradient.node.value());
  for (const JumpRows& jump : point.jumps)
    out += jump.rows * Eigen::Map<const Vec6>(d.data() + 6 * jump.node.value());
  if (point.multiplier == Multiplier::unknown)
    out += Eigen::Map<const Vec2>(d.data() + 6 * point.node.value() + static_cast<std::size_t>(point.column));
  return out;
}

void Equilibrium::add_absolute_products(std::span<const double> d, std::span<double> out) const {
  intact_.multiply_add_absolute(d, out);
  for (const InterfacePoint& point : set_.points) {
    Vec2 sum = Vec2::Zero();
    point.for_each_part([&](BlockId i, const Mat26& rows) {
      sum += rows.cwiseAbs() * Eigen::Map<const Vec6>(d.data() + 6 * i.value()).cwiseAbs();
    });
    const Vec2 force = point.weight * point.intact_stiffness().cwiseProduct(sum);
    point.for_each_part([&](BlockId i, const Mat26& rows) {
      Eigen::Map<Vec6>(out.data() + 6 * i.value()) += rows.cwiseAbs().transpose() * force;
    });
  }
}

void Equilibrium::subtract_weak_forces(std::span<const double> d, std::span<double> out) const {
  parallel_for(num_blocks_, parts_at_once, [&](std::size_t b) {
    const double area = block_size_[b] * block_size_[b];
    Eigen::Map<Vec3>(out.data() + 6 * b) -=
        weak_stiffness_ * Vec3(1, 1, area).cwiseProduct(Eigen::Map<const Vec3>(d.data() + 6 * b));
  });
}

double Equilibrium::passive_energy(std::span<const double> d) const {
  double twice = parallel_sum(num_blocks_, parts_at_once, [&](std::size_t b) {
    const Eigen::Map<const Vec3> strain(d.data() + 6 * b + 3);
    return strain.dot(strain_stiffness_[b] * strain);
  });
  twice += 2 * gradient_energy(d);
  for (const Spring& spring : supports_) {
    const double force = spring.force(d);
    twice += force * force / spring.stiffness;
  }
  twice += parallel_sum(set_.points.size(), parts_at_once,
                        [&](std::size_t p) { return twice_passive_energy(p, d); });
  for (const std::size_t i : held_) twice += held_stiffness_ * d[i] * d[i];
  return twice / 2;
}

double Equilibrium::gradient_energy(std::span<const double> d) const {
  return parallel_sum(gradients_.size(), parts_at_once,
                      [&](std::size_t i) {
                        const Eigen::Map<const Vec6> g(d.data() + 6 * (num_blocks_ + i));
                        return g.dot(gradients_[i].stiffness * g);
                      }) /
         2;
}

double Equilibrium::weak_energy(std::span<const double> d) const {
  return weak_stiffness_ / 2 * parallel_sum(num_blocks_, parts_at_once, [&](std::size_t b) {
           const Eigen::Map<const Vec3> motion(d.data() + 6 * b);
           return motion.dot(Vec3(1, 1, block_size_[b] * block_size_[b]).cwiseProduct(motion));
         });
}

double Equilibrium::twice_passive_energy(std::size_t p, std::span<const double> d) const {
  const InterfacePoint& point = set_.points[p];
  Vec2 stress = Vec2::Zero();
  point.for_each_stress([&](BlockId node, const Mat26& rows) {
    stress += rows * Eigen::Map<const Vec6>(d.data() + 6 * node.value());
  });
  const Vec2 stiffness = point.trial_stiffness();
  double out = -point.weight * stress.dot(stress.cwiseQuotient(stiffness));
  if (point.multiplier == Multiplier::unknown) {
    const Vec2 m(d.data() + 6 * point.node.value() + static_cast<std::size_t>(point.column));
    out -= point.weight * (1 + point.perturbation) * m.dot(stiffness.cwiseProduct(m));
  }
  if (p < set_.num_active) return out;
  const Vec2 q = opening(p, d);
  return out + point.weight * q.dot(point.intact_stiffness().cwiseProduct(q));
}

Functional Equilibrium::opening_gauge(const Loading& loading, std::size_t p, const Vec2& e) const {
  Functional out;
  set_.points[p].for_each_part(
      [&](BlockId part, const Mat26& rows) { out.rows.emplace_back(part, rows.transpose() * e); });
  out.per_load_factor = e.dot(loading.reference_opening(p));
  return out;
}

void Equilibrium::gather(std::span<const double> d, std::span<double> q) const {
  parallel_for(set_.num_active, parts_at_once,
               [&](std::size_t p) { Eigen::Map<Vec2>(q.data() + 2 * p) = opening(p, d); });
}

void Equilibrium::gather(const Loading& loading, std::span<const double> d, double load_factor,
                         std::span<double> q) const {
  gather(d, q);
  for (std::size_t i = 0; i < loading.dead_offset.size(); ++i) q[i] += loading.dead_offset[i];
  for (std::size_t i = 0; i < loading.reference_offset.size(); ++i)
    q[i] += load_factor * loading.reference_offset[i];
}

void Equilibrium::scatter_add(std::span<const double> t, std::span<double> f) const {
  for (std::size_t p = 0; p < set_.num_active; ++p) {
    const Vec2 force = set_.points[p].weight * Eigen::Map<const Vec2>(t.data() + 2 * p);
    if (force.isZero(0)) continue;
    const InterfacePoint& point = set_.points[p];
    Eigen::Map<Vec6>(f.data() + 6 * point.first.value()) += point.rows.first.transpose() * force;
    Eigen::Map<Vec6>(f.data() + 6 * point.second.value()) += point.rows.second.transpose() * force;
    for (const GradientRows& gradient : point.gradients)
      Eigen::Map<Vec6>(f.data() + 6 * gradient.node.value()) += gradient.rows.transpose() * force;
    for (const JumpRows& jump : point.jumps)
      Eigen::Map<Vec6>(f.data() + 6 * jump.node.value()) += jump.rows.transpose() * force;
    if (point.multiplier == Multiplier::unknown)
      Eigen::Map<Vec2>(f.data() + 6 * point.node.value() + static_cast<std::size_t>(point.column)) += force;
  }
}

}  // namespace dda
