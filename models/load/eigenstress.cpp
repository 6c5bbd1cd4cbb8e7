#include "models/load/eigenstress.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <functional>

#include "models/kinematics/second_order.hpp"
#include "models/load/quadrature.hpp"

namespace dda {
namespace {

/// Of the slope along x in a block of second order, behind which is that along y.
std::optional<std::size_t> place_of_slopes(const Body& body, BlockId block) {
  const auto node = body.gradient_of(block);
  if (!node) return {};
  const std::size_t blocks = body.assembly.num_blocks();
  return blocks + 2 * (node->value() - blocks);
}

Vec3 integral_over(const Polygon& polygon, const std::function<Vec3(const Vec2&)>& f) {
  const Integrals sum = integral(polygon, [&](const Vec2& x) {
    Integrals out = Integrals::Zero();
    out.head<3>() = f(x);
    return out;
  });
  return sum.head<3>();
}

}  // namespace

LinearField<Vec3> linear_over(const Body& body, BlockId id, const Components& components) {
  const Block& block = body.block(id);
  const auto value_at = [&](const Vec2& x) -> Vec3 {
    return {components[0](x), components[1](x), components[2](x)};
  };
  const auto& [area, centroid, second] = block.moments;
  const LinearField<Vec3> even{value_at(centroid), {Vec3::Zero(), Vec3::Zero()}};
  if (std::ranges::all_of(components, &Formula::is_constant)) return even;
  const Vec3 mean = integral_over(block.outline, value_at) / area;
  if (!body.gradient_of(id)) return {mean, even.slopes};
  Eigen::Matrix<double, 3, 2> first;
  for (int i = 0; i < 2; ++i)
    first.col(i) = integral_over(
        block.outline, [&, i](const Vec2& x) -> Vec3 { return (x - centroid)[i] * (value_at(x) - mean); });
  const Eigen::Matrix<double, 3, 2> slopes = body.size(id) * first * second.inverse();
  return {mean, {slopes.col(0), slopes.col(1)}};
}

void add_eigenstress(StageLoads& stage, const Body& body, BlockId block,
                     const LinearField<Eigenstress>& eigenstress) {
  const std::size_t places = body.assembly.num_blocks() + 2 * body.num_gradients();
  stage.initial_stress.resize(places, Vec3::Zero());
  stage.out_of_plane.resize(places, 0.0);
  std::vector<Vec3> alone(places, Vec3::Zero());
  const auto add = [&](std::size_t place, const Eigenstress& part) {
    alone[place] = part.stress;
    stage.initial_stress[place] += part.stress;
    stage.out_of_plane[place] += part.out_of_plane;
  };
  add(block.value(), eigenstress.mean);
  if (const auto slopes = place_of_slopes(body, block))
    for (std::size_t i = 0; i < 2; ++i) add(*slopes + i, eigenstress.slopes[i]);
  for (const auto& [node, force] : forces_of_stress(body, block, alone))
    Eigen::Map<Vec6>(stage.force.data() + block_unknowns * node.value()) += force;
}

std::vector<std::pair<BlockId, Vec6>> forces_of_stress(const Body& body, BlockId block,
                                                       std::span<const Vec3> stress) {
  std::vector<std::pair<BlockId, Vec6>> out{{block, Vec6::Zero()}};
  out.front().second.tail<3>() = -body.volume(block) * stress[block.value()];
  const auto slopes = place_of_slopes(body, block);
  if (!slopes) return out;
  Vec6 gradient;
  for (int i = 0; i < 3; ++i) gradient.segment<2>(2 * i) << stress[*slopes][i], stress[*slopes + 1][i];
  const Moments& moments = body.block(block).moments;
  out.emplace_back(
      *body.gradient_of(block),
      -body.thickness * gradient_stiffness(Mat3::Identity(), moments.second, moments.area) * gradient);
  return out;
}

std::vector<StressShare> eigenstress_at(const Body& body, BlockId block, const Vec2& x) {
  std::vector<StressShare> out = eigenstress_beside_mean(body, block, x);
  out.insert(out.begin(), {block.value(), 1});
  return out;
}

std::vector<StressShare> eigenstress_beside_mean(const Body& body, BlockId block, const Vec2& x) {
  const auto slopes = place_of_slopes(body, block);
  if (!slopes) return {};
  const Vec2 share = (x - body.block(block).moments.centroid) / body.size(block);
  return {{*slopes, share.x()}, {*slopes + 1, share.y()}};
}

}  // namespace dda
