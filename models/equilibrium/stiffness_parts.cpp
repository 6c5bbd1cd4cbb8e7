#include "models/equilibrium/stiffness_parts.hpp"

#include <functional>
#include <map>
#include <set>

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;
/// Adds a 6 × 6 matrix to the block (i, j).
using Sink = std::function<void(BlockId, BlockId, const Mat6&)>;

void add_strain(const Equilibrium& equilibrium, const Sink& add) {
  for (std::size_t b = 0; b < equilibrium.num_blocks(); ++b) {
    Mat6 k = Mat6::Zero();
    k.block<3, 3>(3, 3) = equilibrium.strain_stiffness()[b];
    add(BlockId{b}, BlockId{b}, k);
  }
  for (std::size_t i = 0; i < equilibrium.num_gradients(); ++i) {
    const BlockId node{equilibrium.num_blocks() + i};
    add(node, node, equilibrium.gradients()[i].stiffness);
  }
}

void add_weak_springs(const Equilibrium& equilibrium, const Sink& add) {
  for (std::size_t b = 0; b < equilibrium.num_blocks(); ++b) {
    const double size = equilibrium.block_size()[b];
    Mat6 k = Mat6::Zero();
    k.diagonal().head<3>() = equilibrium.weak_stiffness() * Vec3(1, 1, size * size);
    add(BlockId{b}, BlockId{b}, k);
  }
}

void add_springs(const std::vector<Spring>& springs, const Sink& add) {
  for (const Spring& spring : springs)
    for (const auto& [a, left] : spring.displacement.rows)
      for (const auto& [b, right] : spring.displacement.rows)
        add(a, b, spring.stiffness * left * right.transpose());
}

using Rows = std::vector<std::pair<BlockId, Mat26>>;

/// [a]ᵀ D [b] of the nodes of a point.
void add_rows(const Rows& parts, const Mat2& d, const Sink& add) {
  for (const auto& [a, left] : parts)
    for (const auto& [b, right] : parts) add(a, b, left.transpose() * d * right);
}

/// Of blocks, their gradients and jumps.
Rows opening_rows(const InterfacePoint& point) {
  Rows out{{point.first, point.rows.first}, {point.second, point.rows.second}};
  for (const GradientRows& gradient : point.gradients) out.emplace_back(gradient.node, gradient.rows);
  for (const JumpRows& jump : point.jumps) out.emplace_back(jump.node, jump.rows);
  return out;
}

void add_contacts(const Equilibrium& equilibrium, std::span<const Mat2> tangents, const Sink& add) {
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    add_rows(opening_rows(point), point.weight * tangents[p], add);
    if (!point.has_stresses()) continue;
    const Vec2 subtracted = -point.weight * point.trial_stiffness().cwiseInverse();
    Rows stresses;
    point.for_each_stress([&](BlockId node, const Mat26& rows) { stresses.emplace_back(node, rows); });
    add_rows(stresses, subtracted.asDiagonal(), add);
  }
}

/// Unknowns of jumps that are none.
void hold_unused(const Equilibrium& equilibrium, const Sink& add) {
  Mat6 k = Mat6::Zero();
  k.diagonal().tail<3>().setConstant(equilibrium.held_stiffness());
  for (std::size_t j = 0; j < equilibrium.num_jumps(); ++j) {
    const BlockId node{equilibrium.num_block_nodes() + j};
    add(node, node, k);
  }
}

Matrix dense(const Equilibrium& equilibrium, const std::function<void(const Sink&)>& contribution) {
  const auto n = static_cast<Eigen::Index>(block_unknowns * equilibrium.num_leading());
  Matrix out = Matrix::Zero(n, n);
  contribution([&](BlockId i, BlockId j, const Mat6& k) {
    out.block<6, 6>(static_cast<Eigen::Index>(6 * i.value()), static_cast<Eigen::Index>(6 * j.value())) += k;
  });
  return out;
}

/// Pairs of nodes; parts that move by both may have no joint to say so.
std::vector<std::pair<BlockId, BlockId>> jumps_of_one_block(const Equilibrium& equilibrium) {
  std::map<BlockId, std::set<BlockId>> of_block;
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p)
    if (const InterfacePoint& point = equilibrium.point(p); point.first == point.second && !point.is_mirror())
      of_block[point.first].insert(point.jumps.front().node);
  std::vector<std::pair<BlockId, BlockId>> out;
  for (const auto& [block, jumps] : of_block)
    for (auto one = jumps.begin(); one != jumps.end(); ++one)
      for (auto other = std::next(one); other != jumps.end(); ++other) out.emplace_back(*one, *other);
  return out;
}

std::vector<std::pair<BlockId, BlockId>> coupled_blocks(const Equilibrium& equilibrium) {
  std::vector<std::pair<BlockId, BlockId>> out;
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    const Rows rows = opening_rows(equilibrium.point(p));
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = i + 1; j < rows.size(); ++j) out.emplace_back(rows[i].first, rows[j].first);
  }
  for (const auto& [one, other] : jumps_of_one_block(equilibrium)) out.emplace_back(one, other);
  for (std::size_t i = 0; i < equilibrium.num_gradients(); ++i)
    out.emplace_back(equilibrium.gradients()[i].block, BlockId{equilibrium.num_blocks() + i});
  for (const auto* springs : {&equilibrium.supports(), &equilibrium.driven_springs()})
    for (const Spring& spring : *springs)
      for (const auto& [a, left] : spring.displacement.rows)
        for (const auto& [b, right] : spring.displacement.rows)
          if (a < b) out.emplace_back(a, b);
  return out;
}

}  // namespace

StiffnessParts stiffness_parts(const Equilibrium& equilibrium, std::span<const Mat2> tangents) {
  return {.strain = dense(equilibrium,
                          [&](const Sink& add) {
                            add_strain(equilibrium, add);
                            hold_unused(equilibrium, add);
                          }),
          .contact = dense(equilibrium, [&](const Sink& add) { add_contacts(equilibrium, tangents, add); }),
          .support = dense(equilibrium,
                           [&](const Sink& add) {
                             add_springs(equilibrium.supports(), add);
                             add_springs(equilibrium.driven_springs(), add);
                           }),
          .weak = dense(equilibrium, [&](const Sink& add) { add_weak_springs(equilibrium, add); })};
}

BlockMatrix block_stiffness(const Equilibrium& equilibrium, std::span<const Mat2> tangents) {
  BlockMatrix out(equilibrium.num_leading(), coupled_blocks(equilibrium));
  const Sink add = [&](BlockId i, BlockId j, const Mat6& k) { out.add(i, j, k); };
  add_strain(equilibrium, add);
  hold_unused(equilibrium, add);
  add_weak_springs(equilibrium, add);
  add_springs(equilibrium.supports(), add);
  add_springs(equilibrium.driven_springs(), add);
  add_contacts(equilibrium, tangents, add);
  return out;
}

}  // namespace dda
