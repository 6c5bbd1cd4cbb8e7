#include "models/equilibrium.hpp"

#include <cmath>

#include "models/loading.hpp"

namespace dda {
namespace {

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

/// Adds scale · [first second]ᵀ diag(p) [first second] to the four blocks of a pair.
void add_joint(BlockMatrix& matrix, const InterfacePoint& point, const Vec2& p, const Mat26& first,
               const Mat26& second) {
  const Mat26 pf = p.asDiagonal() * first, ps = p.asDiagonal() * second;
  matrix.add(point.first, point.first, first.transpose() * pf);
  matrix.add(point.second, point.second, second.transpose() * ps);
  const Mat6 coupling = first.transpose() * ps;
  matrix.add(point.first, point.second, coupling);
  matrix.add(point.second, point.first, coupling.transpose());
}

}  // namespace

Equilibrium::Equilibrium(const Body& body, const ModelParameters& model)
    : num_blocks_(body.assembly.num_blocks()), intact_(0, {}) {
  Findings findings;
  set_ = make_interface_points(body, model, findings);
  const std::vector<Spring> supports = make_supports(body, model, findings);
  const LoadProgramme programme = make_loads(body, model, findings);
  driven_ = programme.driven;
  std::vector<Spring> springs = supports;
  springs.insert(springs.end(), driven_.begin(), driven_.end());
  check_rigid_motions(body, springs, model.where, findings);
  stages_ = make_stages(body, model, set_, supports, programme, findings);
  findings.throw_if_any();
  for (const Block& block : body.assembly.blocks) block_size_.push_back(std::sqrt(block.moments.area));
  assemble(body, model, springs);
}

void Equilibrium::assemble(const Body& body, const ModelParameters& model,
                           const std::vector<Spring>& springs) {
  auto pairs = touching_blocks(body);
  add_pairs(springs, pairs);
  intact_ = BlockMatrix(num_blocks_, pairs);
  const double weak = model.weak_springs * body.largest_modulus() * body.thickness;
  for (std::size_t i = 0; i < num_blocks_; ++i) {
    const BlockId id{i};
    strain_stiffness_.push_back(body.volume(id) * body.material(id).stiffness());
    Mat6 k = strain_rows().transpose() * strain_stiffness_.back() * strain_rows();
    k.diagonal().head<3>() += weak * Vec3(1, 1, body.block(id).moments.area);
    intact_.add(id, id, k);
  }
  for (const Spring& spring : springs) add_spring(spring);
  for (const InterfacePoint& point : set_.points)
    if (!point.rows.first_stress.isZero() || !point.rows.second_stress.isZero())
      add_joint(intact_, point, -point.weight * point.trial_stiffness().cwiseInverse(),
                point.rows.first_stress, point.rows.second_stress);
  for (const InterfacePoint& point : set_.points)
    add_joint(intact_, point, point.weight * point.trial_stiffness(), point.rows.first, point.rows.second);
}

void Equilibrium::add_spring(const Spring& spring) {
  for (const auto& [a, row_a] : spring.displacement.rows)
    for (const auto& [b, row_b] : spring.displacement.rows)
      intact_.add(a, b, spring.stiffness * row_a * row_b.transpose());
}

Vec2 Equilibrium::opening(std::size_t p, std::span<const double> d) const {
  const InterfacePoint& point = set_.points[p];
  return point.rows.first * Eigen::Map<const Vec6>(d.data() + 6 * point.first.value()) +
         point.rows.second * Eigen::Map<const Vec6>(d.data() + 6 * point.second.value());
}

void Equilibrium::gather(std::span<const double> d, std::span<double> q) const {
  for (std::size_t p = 0; p < set_.num_crackable; ++p) Eigen::Map<Vec2>(q.data() + 2 * p) = opening(p, d);
}

void Equilibrium::gather(const Loading& loading, std::span<const double> d, double load_factor,
                         std::span<double> q) const {
  gather(d, q);
  for (std::size_t i = 0; i < loading.dead_offset.size(); ++i) q[i] += loading.dead_offset[i];
  for (std::size_t i = 0; i < loading.reference_offset.size(); ++i)
    q[i] += load_factor * loading.reference_offset[i];
}

void Equilibrium::scatter_add(std::span<const double> t, std::span<double> f) const {
  for (std::size_t p = 0; p < set_.num_crackable; ++p) {
    const Vec2 force = set_.points[p].weight * Eigen::Map<const Vec2>(t.data() + 2 * p);
    if (force.isZero(0)) continue;
    const InterfacePoint& point = set_.points[p];
    Eigen::Map<Vec6>(f.data() + 6 * point.first.value()) += point.rows.first.transpose() * force;
    Eigen::Map<Vec6>(f.data() + 6 * point.second.value()) += point.rows.second.transpose() * force;
  }
}

}  // namespace dda
