#include "continuation/handover/pieces.hpp"

#include <Eigen/Cholesky>

#include "meshing/geometry/triangle_rule.hpp"
#include "models/body/motion.hpp"

namespace dda {
namespace {

/// The motion of first order that is closest to that of a block's strain gradient over a piece of it, as its mass weighs
/// it: ∫ Tᵀ(T x − G g) dA = 0, so that momentum is kept.
Vec6 closest_motion(const Body& whole, BlockId block, const Block& piece, const Vec6& g) {
  const Vec2& centroid = piece.moments.centroid;
  Mat6 mass = Mat6::Zero();
  Vec6 moved = Vec6::Zero();
  for_each_quadrature_point(piece.outline, centroid, [&](double weight, const Vec2& x) {
    const Mat26 rows = displacement_rows(x - centroid);
    mass += weight * rows.transpose() * rows;
    moved += weight * rows.transpose() * (gradient_motion(whole, block, x) * g);
  });
  return mass.ldlt().solve(moved);
}

}  // namespace

Pieces::Pieces(const Body& whole, const Equilibrium& equilibrium, const ModelParameters& model)
    : whole_(whole), of_whole_(equilibrium) {
  if (whole.num_jumps() > 0) parted_ = parted(*whole.cracks);
  if (!parted_ && whole.num_gradients() == 0) return;
  body_ = std::make_unique<const Body>(
      Body{parted_ ? parted_->assembly : whole.assembly, whole.thickness, whole.materials});
  equilibrium_ = std::make_unique<const Equilibrium>(*body_, model, equilibrium.history());
}

Vec6 Pieces::displacements(std::size_t piece, std::span<const double> d) const {
  const auto node = [&](BlockId id) {
    return Eigen::Map<const Vec6>(d.data() + block_unknowns * id.value());
  };
  if (!body_) return node(BlockId{piece});
  const auto [whole, jumps] = parted_ ? parted_->pieces[piece] : Parted::Piece{BlockId{piece}, {}};
  const Block& block = body_->block(BlockId{piece});
  const Vec2 centroid = block.moments.centroid;
  Vec6 out = node(whole);
  out.head<2>() = displacement_rows(centroid - whole_.block(whole).moments.centroid) * node(whole);
  for (const JumpId jump : jumps) {
    const NodeMotion here = motion_of(whole_, jump, centroid),
                     aside = motion_of(whole_, jump, centroid + Vec2::UnitX());
    out.head<2>() += here.rows * node(here.node);
    out[2] += ((aside.rows - here.rows) * node(here.node)).y();
  }
  if (const auto gradient = whole_.gradient_of(whole))
    out += closest_motion(whole_, whole, block, node(*gradient));
  return out;
}

std::pair<std::size_t, std::size_t> Pieces::beside(const InterfacePoint& point) const {
  if (!parted_) return {point.first.value(), point.second.value()};
  const CrackGeometry& cracks = *whole_.cracks;
  if (point.cut && !cracks.cuts()[*point.cut].side) {
    const CrackGeometry::Beside at = cracks.beside(cracks.cuts()[*point.cut], point.x);
    return {parted_->at(point.first, at.left), parted_->at(point.first, at.right)};
  }
  return {parted_->at(point.first, cracks.jumps_at(point.first, point.x)),
          parted_->at(point.second, cracks.jumps_at(point.second, point.x))};
}

}  // namespace dda
