#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <limits>

#include "support/structure.hpp"

namespace dda {
namespace {

std::vector<double> force(const Equilibrium& equilibrium, const std::vector<double>& d) {
  std::vector<double> out(d.size(), 0.0);
  equilibrium.intact().multiply_add(d, out);
  return out;
}

double norm(const std::vector<double>& v) {
  return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())).norm();
}

const std::string held = "stages:\n  - loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]\n";

/// The square with supports so soft that only the joints and blocks resist.
Structure nearly_free() { return Structure(square_deck(held + "support_stiffness: 1e-13\n")); }

TEST(Equilibrium, RigidMotionsCostNothing) {
  const Structure square = nearly_free();
  const Equilibrium equilibrium = square.equilibrium();
  Mat2 turn;
  turn << 0, -1, 1, 0;
  for (const std::vector<double>& d :
       {square.field({1, 0}, Mat2::Zero()), square.field({0, 1}, Mat2::Zero()), square.field({0, 0}, turn)})
    EXPECT_LT(norm(force(equilibrium, d)), 1e-11);
}

/// Slender columns turned as one: what is left of forces that cancel is rounding of the products counted, and
/// more than |K0| |d| tells, where entries have cancelled before.
TEST(Equilibrium, AbsoluteProductsBoundTheRounding) {
  std::string deck = "scene:\n  regions:\n";
  for (int i = 0; i < 8; ++i) {
    const std::string from = std::to_string(0.003 * i), to = std::to_string(0.003 * (i + 1));
    deck += "    - {name: column" + std::to_string(i) + ", material: stone, vertices: [[" + from + ", 0], [" +
            to + ", 0], [" + to + ", 1], [" + from + ", 1]]}\n";
  }
  deck +=
      "thickness: 1\nsupport_stiffness: 1e-13\n"
      "materials: {stone: {type: linear_elastic, young_modulus: 1, poisson_ratio: 0.2}}\n"
      "interfaces: {joint: {between: [stone, stone], law: bonded, treatment: {type: penalty, factor: 1e4}}}\n"
      "supports: {foot: {at: [0, 0], fix: xy}, side: {at: [0, 1], fix: x}}\n"
      "stages: [{loads: [{type: point_load, at: [0, 1], force: [1, 0]}]}]\n";
  const Structure columns(deck);
  const Equilibrium equilibrium = columns.equilibrium();
  Mat2 turn;
  turn << 0, -1, 1, 0;
  const std::vector<double> d = columns.field({0.3, 0.7}, turn), left = force(equilibrium, d);
  std::vector<double> all(d.size(), 0.0), of_entries(d.size(), 0.0);
  equilibrium.add_absolute_products(d, all);
  equilibrium.intact().multiply_add_absolute(d, of_entries);
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  int more = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    EXPECT_LE(std::abs(left[i]), rounding * all[i]) << "row " << i;
    more += std::abs(left[i]) > rounding * of_entries[i];
  }
  EXPECT_GT(more, 0);
}

/// Uniform strain in one material: the forces are those of the uniform stress on the boundary, whatever the
/// joints.
TEST(Equilibrium, UniformStrainIsHeldByItsBoundaryTractions) {
  for (const std::string treatment : {"consistent", "penalty"}) {
    const std::string joints = "  joint: {between: [mortar, stone], treatment: " + treatment + "}\n" +
                               "  inner: {between: [mortar, mortar], treatment: " + treatment + "}\n" +
                               "  outer: {between: [stone, stone], treatment: " + treatment + "}\n";
    std::string deck = square_deck(held + "support_stiffness: 1e-13\n", joints);
    deck.replace(deck.find("young_modulus: 3, poisson_ratio: 0.3"), 36,
                 "young_modulus: 2, poisson_ratio: 0.2");
    const Structure square(deck);
    const Equilibrium equilibrium = square.equilibrium();
    Mat2 g;
    g << 0.1, 0.3, -0.2, 0.2;
    const std::vector<double> inner = force(equilibrium, square.field({1, 2}, g));
    Vec3 strain(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
    const Vec3 stress = square.body().materials[0]->stiffness() * strain;
    Mat2 tensor;
    tensor << stress.x(), stress.z(), stress.z(), stress.y();
    StageLoads outer = square.no_loads();
    for (const BoundarySide& side : square.assembly().boundary) {
      const Vec2 edge = side.end - side.start, n(edge.y(), -edge.x());
      add_point_force(outer, square.body(), side.block, {(side.start + side.end) / 2, 0.7 * tensor * n});
    }
    double difference = 0;
    for (std::size_t i = 0; i < inner.size(); ++i) difference += std::pow(inner[i] - outer.force[i], 2);
    // Penalty joints do not carry the stress of the blocks: blocks alone balance nothing there.
    if (treatment == "consistent")
      EXPECT_LT(std::sqrt(difference), 1e-11);
    else
      EXPECT_GT(std::sqrt(difference), 1e-2);
  }
}

TEST(Equilibrium, IntactStiffnessIsSymmetricPositiveDefinite) {
  const Structure square(square_deck());
  const Equilibrium equilibrium = square.equilibrium();
  const auto n = static_cast<Eigen::Index>(equilibrium.num_unknowns());
  Eigen::MatrixXd k(n, n);
  for (Eigen::Index c = 0; c < n; ++c) {
    std::vector<double> unit(static_cast<std::size_t>(n), 0.0);
    unit[static_cast<std::size_t>(c)] = 1;
    k.col(c) = Eigen::Map<const Eigen::VectorXd>(force(equilibrium, unit).data(), n);
  }
  EXPECT_LT((k - k.transpose()).norm(), 1e-13 * k.norm());
  EXPECT_EQ(k.llt().info(), Eigen::Success);
}

TEST(Equilibrium, CrackablePointsComeFirst) {
  const Structure square(square_deck());
  const Equilibrium equilibrium = square.equilibrium();
  EXPECT_EQ(equilibrium.num_active(), 4u) << "two sides between mortar and stone, two Gauss points each";
  EXPECT_EQ(equilibrium.num_points(), 8u);
  double area = 0;
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    EXPECT_EQ(equilibrium.point(p).law->can_crack(), p < 4);
    area += equilibrium.point(p).weight;
  }
  double length = 0;
  for (const Side& side : square.assembly().sides) length += (side.end - side.start).norm();
  EXPECT_NEAR(area, 0.7 * length, 1e-14);
}

TEST(Equilibrium, ScatteringIsTheTransposeOfGathering) {
  const Structure square(square_deck());
  const Equilibrium equilibrium = square.equilibrium();
  Random random(6);
  const std::vector<double> d = random.vector(24, 1), t = random.vector(8, 1);
  std::vector<double> q(8), f(24, 0.0);
  equilibrium.gather(d, q);
  equilibrium.scatter_add(t, f);
  double left = 0, right = 0;
  for (std::size_t i = 0; i < 24; ++i) left += f[i] * d[i];
  for (std::size_t i = 0; i < 8; ++i) right += equilibrium.point(i / 2).weight * t[i] * q[i];
  EXPECT_NEAR(left, right, 1e-13 * std::abs(right));
}

}  // namespace
}  // namespace dda
