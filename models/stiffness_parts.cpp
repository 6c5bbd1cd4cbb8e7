#include "models/stiffness_parts.hpp"

#include <cassert>

namespace dda {
namespace {

using Matrix = Eigen::MatrixXd;

Eigen::Index row(BlockId block) { return static_cast<Eigen::Index>(block_unknowns * block.value()); }

/// [a]ᵀ D [b] of both blocks of a point.
void add_rows(Matrix& to, const InterfacePoint& point, const Mat2& d, const PointRows& rows) {
  const std::pair<BlockId, Mat26> parts[] = {{point.first, rows.first}, {point.second, rows.second}};
  for (const auto& [a, left] : parts)
    for (const auto& [b, right] : parts) to.block<6, 6>(row(a), row(b)) += left.transpose() * d * right;
}

void add_spring(Matrix& to, const Spring& spring) {
  for (const auto& [a, left] : spring.displacement.rows)
    for (const auto& [b, right] : spring.displacement.rows)
      to.block<6, 6>(row(a), row(b)) += spring.stiffness * left * right.transpose();
}

}  // namespace

StiffnessParts stiffness_parts(const Equilibrium& equilibrium, std::span<const Mat2> tangents) {
  assert(equilibrium.num_unknown_multipliers() == 0);
  const auto n = static_cast<Eigen::Index>(equilibrium.num_unknowns());
  StiffnessParts out{Matrix::Zero(n, n), Matrix::Zero(n, n), Matrix::Zero(n, n), Matrix::Zero(n, n)};
  for (std::size_t b = 0; b < equilibrium.num_blocks(); ++b) {
    const Eigen::Index at = row(BlockId{b});
    const double size = equilibrium.block_size()[b];
    out.strain.block<3, 3>(at + 3, at + 3) += equilibrium.strain_stiffness()[b];
    out.weak.diagonal().segment<3>(at) += equilibrium.weak_stiffness() * Vec3(1, 1, size * size);
  }
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    const InterfacePoint& point = equilibrium.point(p);
    const Mat2 d = p < tangents.size() ? tangents[p] : Mat2(point.intact_stiffness().asDiagonal());
    add_rows(out.contact, point, point.weight * d, point.rows);
    const Vec2 subtracted = -point.weight * point.trial_stiffness().cwiseInverse();
    add_rows(out.contact, point, subtracted.asDiagonal(),
             {.first = point.rows.first_stress, .second = point.rows.second_stress});
  }
  for (const Spring& spring : equilibrium.supports()) add_spring(out.support, spring);
  for (const Spring& spring : equilibrium.driven_springs()) add_spring(out.support, spring);
  return out;
}

}  // namespace dda
