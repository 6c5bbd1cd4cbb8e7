#include "models/body/mass.hpp"

#include <algorithm>
#include <array>

#include "meshing/geometry/triangle_rule.hpp"
#include "models/body/motion.hpp"

namespace dda {
namespace {

/// N linear in the place, N = N0 + X N_x + Y N_y about a centroid.
struct LinearRows {
  Mat26 at_centre;
  std::array<Mat26, 2> slopes;
};

template <class Rows>
LinearRows about(const Vec2& centroid, const Rows& rows) {
  const Mat26 at_centre = rows(centroid);
  return {at_centre,
          {rows(centroid + Vec2::UnitX()) - at_centre, rows(centroid + Vec2::UnitY()) - at_centre}};
}

/// ∫ AᵀB dA = A A0ᵀB0 + Σ S_ij A_iᵀB_j with the second moments S about the centroid.
Mat6 integral(const LinearRows& a, const LinearRows& b, const Moments& moments) {
  Mat6 out = moments.area * a.at_centre.transpose() * b.at_centre;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      out += moments.second(i, j) * a.slopes[static_cast<std::size_t>(i)].transpose() *
             b.slopes[static_cast<std::size_t>(j)];
  return out;
}

Mat6 integral_of(const Block& block) {
  const LinearRows rows = about(Vec2(Vec2::Zero()), displacement_rows);
  return integral(rows, rows, block.moments);
}

/// ∫ AᵀB dA of rows that vary with the place, to their product's degree of four.
template <class A, class B>
Mat6 integral_of_products(const Polygon& polygon, const Vec2& centre, const A& a, const B& b) {
  Mat6 out = Mat6::Zero();
  for_each_quadrature_point(polygon, centre,
                            [&](double weight, const Vec2& x) { out += weight * a(x).transpose() * b(x); });
  return out;
}

/// The strain gradient of a block of second order, and what it shares with its block.
void add_gradient(const Body& body, BlockId id, double per_area, Mass& out) {
  const Block& block = body.block(id);
  const Vec2& centroid = block.moments.centroid;
  const BlockId node = *body.gradient_of(id);
  const auto own = [&](const Vec2& x) { return displacement_rows(x - centroid); };
  const auto gradient = [&](const Vec2& x) { return gradient_motion(body, id, x); };
  out.diagonal.push_back(per_area * integral_of_products(block.outline, centroid, gradient, gradient));
  out.couplings.push_back(
      {id, node, per_area * integral_of_products(block.outline, centroid, own, gradient)});
}

/// What the strain gradient of a block shares with the jumps by which a part of it moves, of a unit of mass per area.
std::vector<Mass::Coupling> gradient_and_part(const Body& body, BlockId id, const Part& part) {
  std::vector<Mass::Coupling> out;
  const auto node = body.gradient_of(id);
  if (!node) return out;
  const Vec2 of_part = moments(part.outline).centroid;
  const auto gradient = [&](const Vec2& x) { return gradient_motion(body, id, x); };
  for (const JumpId jump : part.jumps) {
    const auto moved = [&](const Vec2& x) { return motion_of(body, jump, x).rows; };
    out.push_back({*node, body.node_of(jump), integral_of_products(part.outline, of_part, gradient, moved)});
  }
  return out;
}

/// What the parts of a block of some mass per area that move beside it add to the nodes of their jumps, and share with the
/// block.
void add_parts(const Body& body, BlockId block, double per_area, Mass& out) {
  const Vec2& centroid = body.block(block).moments.centroid;
  for (const Part& part : body.cracks->parts(block)) {
    const Moments of_part = moments(part.outline);
    std::vector<std::pair<BlockId, LinearRows>> moves{
        {block, about(of_part.centroid, [&](const Vec2& x) { return displacement_rows(x - centroid); })}};
    for (const JumpId jump : part.jumps)
      moves.emplace_back(body.node_of(jump), about(of_part.centroid, [&](const Vec2& x) {
                           return motion_of(body, jump, x).rows;
                         }));
    for (std::size_t i = 0; i < moves.size(); ++i)
      for (std::size_t j = std::max<std::size_t>(i, 1); j < moves.size(); ++j) {
        const Mat6 m = per_area * integral(moves[i].second, moves[j].second, of_part);
        if (i == j)
          out.diagonal[moves[i].first.value()] += m;
        else
          out.couplings.push_back({moves[i].first, moves[j].first, m});
      }
    for (const auto& [node, jump, m] : gradient_and_part(body, block, part))
      out.couplings.push_back({node, jump, per_area * m});
  }
}

/// By densities of the blocks.
Mass mass_with(const Body& body, const std::vector<double>& densities) {
  Mass out;
  const auto per_area = [&](std::size_t b) { return densities[b] * body.thickness; };
  for (std::size_t b = 0; b < densities.size(); ++b)
    out.diagonal.push_back(per_area(b) * integral_of(body.block(BlockId{b})));
  for (const BlockId id : body.second_order.blocks) add_gradient(body, id, per_area(id.value()), out);
  if (!body.cracks) return out;
  constexpr double next_to_none = 1e-9;
  for (std::size_t j = 0; j < body.num_jumps(); ++j) {
    const BlockId cut = body.cracks->cut_of(JumpId{j}).block;
    Mat6 unused = Mat6::Zero();
    unused.diagonal().tail<3>().setConstant(next_to_none * per_area(cut.value()) *
                                            body.block(cut).moments.area);
    out.diagonal.push_back(unused);
  }
  for (std::size_t b = 0; b < densities.size(); ++b) add_parts(body, BlockId{b}, per_area(b), out);
  return out;
}

}  // namespace

void Mass::multiply(std::span<const double> x, std::span<double> y) const {
  const auto of = [](auto values, BlockId node) { return values.data() + block_unknowns * node.value(); };
  for (std::size_t b = 0; b < num_nodes(); ++b)
    Eigen::Map<Vec6>(of(y, BlockId{b})) = diagonal[b] * Eigen::Map<const Vec6>(of(x, BlockId{b}));
  for (const auto& [i, j, m] : couplings) {
    Eigen::Map<Vec6>(of(y, i)) += m * Eigen::Map<const Vec6>(of(x, j));
    Eigen::Map<Vec6>(of(y, j)) += m.transpose() * Eigen::Map<const Vec6>(of(x, i));
  }
}

void Mass::add_to(BlockMatrix& k, double s) const {
  for (std::size_t b = 0; b < num_nodes(); ++b) k.add(BlockId{b}, BlockId{b}, s * diagonal[b]);
  for (const auto& [i, j, m] : couplings) {
    k.add(i, j, s * m);
    k.add(j, i, s * m.transpose());
  }
}

Eigen::MatrixXd Mass::dense() const {
  const auto at = [](std::size_t node) { return static_cast<Eigen::Index>(block_unknowns * node); };
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(at(num_nodes()), at(num_nodes()));
  for (std::size_t b = 0; b < num_nodes(); ++b) out.block<6, 6>(at(b), at(b)) = diagonal[b];
  for (const auto& [i, j, m] : couplings) {
    out.block<6, 6>(at(i.value()), at(j.value())) += m;
    out.block<6, 6>(at(j.value()), at(i.value())) += m.transpose();
  }
  return out;
}

Mass unit_mass(const Body& body) {
  return mass_with(body, std::vector<double>(body.assembly.num_blocks(), 1));
}

Mass mass_of(const Body& body) {
  std::vector<double> densities;
  for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b)
    densities.push_back(body.material(BlockId{b}).density());
  return mass_with(body, densities);
}

}  // namespace dda
