#include "continuation/handover/pieces.hpp"

#include "models/body/motion.hpp"

namespace dda {

Pieces::Pieces(const Body& whole, const Equilibrium& equilibrium, const ModelParameters& model)
    : whole_(whole), of_whole_(equilibrium) {
  if (!whole.cracks || whole.cracks->num_jumps() == 0) return;
  parted_ = parted(*whole.cracks);
  body_ = std::make_unique<const Body>(Body{parted_->assembly, whole.thickness, whole.materials});
  equilibrium_ = std::make_unique<const Equilibrium>(*body_, model);
}

Vec6 Pieces::displacements(std::size_t piece, std::span<const double> d) const {
  const auto node = [&](BlockId id) {
    return Eigen::Map<const Vec6>(d.data() + block_unknowns * id.value());
  };
  if (!parted_) return node(BlockId{piece});
  const auto& [whole, jumps] = parted_->pieces[piece];
  const Vec2 centroid = body_->block(BlockId{piece}).moments.centroid;
  Vec6 out = node(whole);
  out.head<2>() = displacement_rows(centroid - whole_.block(whole).moments.centroid) * node(whole);
  for (const JumpId jump : jumps) {
    const NodeMotion here = motion_of(whole_, jump, centroid),
                     aside = motion_of(whole_, jump, centroid + Vec2::UnitX());
    out.head<2>() += here.rows * node(here.node);
    out[2] += ((aside.rows - here.rows) * node(here.node)).y();
  }
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
