#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "models/body/mass.hpp"
#include "models/body/motion.hpp"
#include "models/crack/growth.hpp"
#include "models/equilibrium/stiffness_parts.hpp"
#include "models/kinematics/second_order.hpp"
#include "support/cut_structure.hpp"
#include "support/dense.hpp"
#include "support/random.hpp"

namespace dda {
namespace {

using Vector = Eigen::VectorXd;

struct Pattern {
  std::string subdivision;
  std::string kinematics = "first_order";

  std::string more() const { return "kinematics: " + kinematics + "\n"; }
};

std::ostream& operator<<(std::ostream& out, const Pattern& pattern) {
  return out << pattern.subdivision << ", " << pattern.kinematics;
}

const std::vector<Pattern> patterns{{"{type: voronoi, blocks: 60, seed: 3}"},
                                    {"{type: triangles, size: 2.5}"},
                                    {"{type: grid, columns: 12, rows: 4}"},
                                    {"{type: voronoi, blocks: 30, seed: 3}", "second_order"},
                                    {"{type: grid, columns: 12, rows: 4}", "second_order"}};

Vector vector(const std::vector<double>& v) {
  return Eigen::Map<const Vector>(v.data(), static_cast<Eigen::Index>(v.size()));
}

/// Slightly inclined cracks, one of which crosses what another has cut, and a flat one that ends on another.
int cut_some(CutStructure& structure) {
  const int cuts = structure.cut_straight({11.3, 0}, {0.07, 1}) +
                   structure.cut_straight({12.1, 0}, {0.05, 1}, 2) +
                   structure.cut_straight({20.2, 10}, {-0.2, -1}, 4);
  const int into_another = structure.cut_straight({0, 4.3}, {1, 0.02});
  EXPECT_TRUE(structure.cracks().is_on_crack(structure.cracks().cuts().back().end, 1));
  EXPECT_LT(structure.cracks().cuts().back().end.x(), 12);
  return cuts + into_another;
}

TEST(CutBlocks, TheOldUnknownsKeepTheirStiffness) {
  for (const Pattern& pattern : patterns) {
    CutStructure structure({.subdivision = pattern.subdivision, .more = pattern.more()});
    const Eigen::MatrixXd before = dense(structure.equilibrium().intact());
    ASSERT_GE(cut_some(structure), 9);
    const Equilibrium cut = structure.equilibrium();
    const Eigen::MatrixXd after = dense(cut.intact());
    const Eigen::Index n = before.rows();
    ASSERT_EQ(after.rows(), n + 6 * static_cast<Eigen::Index>(structure.cracks().num_jumps()));
    EXPECT_LT((after.topLeftCorner(n, n) - before).cwiseAbs().maxCoeff(),
              1e-14 * before.cwiseAbs().maxCoeff())
        << pattern;
    EXPECT_LT((after - after.transpose()).norm(), 1e-14 * after.norm());
  }
}

TEST(CutBlocks, UniformStressGoesThroughClosedCuts) {
  Mat2 g;
  g << 0.1, 0.3, -0.2, 0.2;
  for (const Pattern& pattern : patterns) {
    CutStructure structure({.subdivision = pattern.subdivision, .more = pattern.more()});
    ASSERT_GE(cut_some(structure), 9);
    const Mat3 c = structure.body().materials[0]->stiffness();
    const Vec3 stress = c * Vec3(g(0, 0), g(1, 1), g(0, 1) + g(1, 0));
    Mat2 tensor;
    tensor << stress.x(), stress.z(), stress.z(), stress.y();
    const Equilibrium equilibrium = structure.equilibrium();
    const std::vector<double> d = structure.field(g);
    std::vector<double> inner(d.size(), 0.0);
    equilibrium.intact().multiply_add(d, inner);
    const Vector outer = vector(structure.tractions(tensor).force);
    EXPECT_LT((vector(inner) - outer).norm(), 1e-12 * outer.norm()) << pattern;
    for (std::size_t p = 0; p < equilibrium.num_active(); ++p) {
      const InterfacePoint& point = equilibrium.point(p);
      const Vec2 t = point.intact_stiffness().cwiseProduct(equilibrium.opening(p, d));
      const Vec2 wanted = traction_rows(point.normal) * stress;
      EXPECT_LT((t - wanted).norm(), 1e-12 * wanted.norm());
    }
  }
}

/// α next to its bound, the cuts' stiffness at theirs, slivers and blocks cut twice among them.
TEST(CutBlocks, AreDefiniteAtTheBounds) {
  for (const Pattern& pattern : patterns) {
    CutStructure structure({.subdivision = pattern.subdivision,
                            .alpha = 0.51,
                            .stiffness = 0,
                            .more = pattern.more(),
                            .support_stiffness = 1e-3});
    ASSERT_GE(cut_some(structure), 9);
    structure.cut_straight({2.5 + 1e-6, 0}, {0, 1});
    const Equilibrium equilibrium = structure.equilibrium();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(dense(equilibrium.intact()),
                                                               Eigen::EigenvaluesOnly);
    EXPECT_GT(found.eigenvalues()(0), 0) << pattern;
  }
}

/// A frame of one block around another: its legs are cut one by one.
TEST(CutBlocks, AreDefiniteWhereTheyAreNotConvex) {
  Structure frame(
      "scene:\n  regions:\n"
      "    - {name: body, material: stone, vertices: [[0, 0], [3, 0], [3, 2], [2, 2], [2, 1], [1, 1], [1, "
      "2], [0, 2]]}\n"
      "    - {name: core, material: stone, vertices: [[1, 1], [2, 1], [2, 2], [1, 2]]}\n"
      "thickness: 1\n"
      "materials: {stone: {type: linear_elastic, young_modulus: 2, poisson_ratio: 0.2}}\n"
      "interfaces: {joint: {between: [stone, stone], treatment: {type: consistent, alpha: 0.51}, law: "
      "{type: linear_softening, tensile_strength: 0.01, fracture_energy: 0.01}}}\n"
      "supports: {foot: {at: [0, 0], fix: xy}, side: {at: [3, 0], fix: y}}\n"
      "stages: [{loads: [{type: point_load, at: [3, 2], force: [1, 0]}]}]\n");
  CrackGeometry cracks(frame.assembly());
  ASSERT_TRUE(cracks.cut(BlockId{0}, {0, 1.5}, {1, 1.5}, 0));
  ASSERT_TRUE(cracks.cut(BlockId{1}, {1, 1.5}, {2, 1.5}, 0));
  ASSERT_TRUE(cracks.cut(BlockId{0}, {2, 1.5}, {3, 1.5}, 0));
  ModelDeck deck = frame.deck();
  deck.cracks.push_back(cracks_through({"body", "core"}, 0));
  Body body = frame.body();
  body.cracks = &cracks;
  const Equilibrium equilibrium(body, deck);
  EXPECT_EQ(dense(equilibrium.intact()).llt().info(), Eigen::Success);
}

/// ∫ f dA over a triangle by Gauss points towards its first corner, exact to degree four.
template <class Function>
double integral(const Vec2& a, const Vec2& b, const Vec2& c, const Function& f) {
  const double g = std::sqrt(0.6) / 2;
  const std::pair<double, double> rule[] = {{0.5 - g, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + g, 5.0 / 18}};
  double sum = 0;
  for (const auto& [s, ws] : rule)
    for (const auto& [t, wt] : rule) sum += ws * wt * s * f(a + s * (b - a + t * (c - b)));
  return cross(b - a, c - a) * sum;
}

/// ∫ |u|² dV over the triangles of a fan.
double kinetic(const CutStructure& structure, const Vector& d) {
  const Body& body = structure.body();
  double sum = 0;
  const auto add = [&](BlockId block, const std::vector<Vec2>& outline, std::span<const JumpId> jumps) {
    const auto square = [&](const Vec2& x) {
      const auto of = [&](BlockId node) { return d.segment<6>(6 * static_cast<Eigen::Index>(node.value())); };
      Vec2 u = displacement_rows(x - body.block(block).moments.centroid) * of(block);
      if (const auto node = body.gradient_of(block))
        u += gradient_displacement_rows(x - body.block(block).moments.centroid, body.size(block)) * of(*node);
      for (const JumpId jump : jumps) u += motion_of(body, jump, x).rows * of(body.node_of(jump));
      return u.squaredNorm();
    };
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
      sum += integral(outline[0], outline[i], outline[i + 1], square);
  };
  for (std::size_t b = 0; b < body.assembly.num_blocks(); ++b) {
    const auto parts = body.cracks->parts(BlockId{b});
    for (const Part& part : parts) add(BlockId{b}, part.outline.vertices, part.jumps);
    if (parts.empty()) add(BlockId{b}, body.block(BlockId{b}).outline.vertices, {});
  }
  return body.thickness * sum;
}

TEST(CutBlocks, MoveWithTheMassOfTheirParts) {
  for (const Pattern& pattern : patterns) {
    CutStructure structure({.subdivision = pattern.subdivision, .more = pattern.more()});
    ASSERT_GE(cut_some(structure), 9);
    const Mass mass = unit_mass(structure.body());
    const Eigen::MatrixXd m = mass.dense();
    Random random(5);
    Vector d = Vector::NullaryExpr(m.rows(), [&](Eigen::Index) { return random.between(-1, 1); });
    for (std::size_t j = 0; j < structure.body().num_jumps(); ++j)
      d.segment<3>(6 * static_cast<Eigen::Index>(structure.body().node_of(JumpId{j}).value()) + 3).setZero();
    const double wanted = kinetic(structure, d);
    EXPECT_NEAR(d.dot(m * d), wanted, 1e-12 * wanted) << pattern;
    std::vector<double> product(static_cast<std::size_t>(m.rows()));
    mass.multiply({d.data(), product.size()}, product);
    EXPECT_LT((vector(product) - m * d).norm(), 1e-14 * (m * d).norm());
    EXPECT_EQ(m.llt().info(), Eigen::Success) << pattern;
  }
}

/// Of blocks and gradients all unknowns, of jumps the three that are some.
std::vector<Eigen::Index> used_unknowns(const CutStructure& structure) {
  std::vector<Eigen::Index> out;
  const auto blocks =
      static_cast<Eigen::Index>(structure.assembly().num_blocks() + structure.body().num_gradients());
  for (Eigen::Index node = 0; node < static_cast<Eigen::Index>(structure.body().num_nodes()); ++node)
    for (Eigen::Index i = 0; i < (node < blocks ? 6 : 3); ++i) out.push_back(6 * node + i);
  return out;
}

/// Three eigenvalues of K φ = μ M φ are those of a free body where nothing is left of a cut all through, none before.
TEST(CutBlocks, WhatIsSeveredMovesFreely) {
  for (const Pattern& pattern : patterns) {
    CutStructure structure(
        {.subdivision = pattern.subdivision, .more = pattern.more(), .support_stiffness = 1e3});
    ASSERT_GE(structure.cut_straight({11.3, 0}, {0.07, 1}), 3);
    const Equilibrium equilibrium = structure.equilibrium();
    std::vector<Mat2> tangents;
    for (std::size_t p = 0; p < equilibrium.num_points(); ++p)
      tangents.emplace_back(equilibrium.point(p).intact_stiffness().asDiagonal());
    const std::vector<Eigen::Index> used = used_unknowns(structure);
    const Eigen::MatrixXd mass = unit_mass(structure.body()).dense()(used, used);
    const auto lowest = [&](bool is_severed) {
      std::vector<Mat2> now = tangents;
      for (std::size_t p = 0; p < equilibrium.num_points(); ++p)
        if (is_severed && equilibrium.point(p).cut) now[p].setZero();
      BlockMatrix k = block_stiffness(equilibrium, now);
      for (std::size_t p = 0; is_severed && p < equilibrium.num_active(); ++p)
        add_stress_energy(k, equilibrium.point(p));
      const Eigen::MatrixXd stiffness = dense(k)(used, used);
      return Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(stiffness, mass,
                                                                       Eigen::EigenvaluesOnly)
          .eigenvalues()
          .head<4>()
          .eval();
    };
    const auto whole = lowest(false), severed = lowest(true);
    EXPECT_GT(whole[0], 1e-6 * whole[3]) << pattern;
    EXPECT_LT(severed.head<3>().cwiseAbs().maxCoeff(), 1e-10 * severed[3]) << pattern;
    EXPECT_GT(severed[3], whole[0]) << "the shorter piece that is held is stiffer";
  }
}

/// f · K0⁻¹ f of the stage's load.
double compliance(const Equilibrium& equilibrium) {
  const Vector f = vector(equilibrium.stages().back().reference);
  return f.dot(dense(equilibrium.intact()).llt().solve(f));
}

const std::string bending = "stages: [{loads: [{type: point_load, at: [15, 10], force: [0, -1]}]}]\n";
const std::string beam_supports = "{left: {at: [0, 0], fix: xy}, right: {at: [30, 0], fix: y}}";

TEST(CutBlocks, NineClosedCutsHardlyChangeTheCompliance) {
  CutStructure structure({.subdivision = "{type: voronoi, blocks: 327}",
                          .more = bending,
                          .supports = beam_supports,
                          .support_stiffness = 1e5});
  const double before = compliance(structure.equilibrium());
  ASSERT_EQ(structure.cut_straight({15.3, 0}, {0.02, 1}, 9), 9);
  const double after = compliance(structure.equilibrium());
  EXPECT_GE(after, before);
  EXPECT_LT(after / before - 1, 1e-5);
}

/// A beam cut all through by `away` beside a line of its grid, in units of the spacing.
std::unique_ptr<CutStructure> cut_beside_a_line(int rows, double away) {
  auto out = std::make_unique<CutStructure>(
      CutStructure::Wish{.subdivision = fmt::format("{{type: grid, columns: {}, rows: {}}}", 3 * rows, rows),
                         .more = bending,
                         .supports = beam_supports,
                         .support_stiffness = 1e5});
  const double h = 10.0 / rows;
  EXPECT_EQ(out->cut_straight({(std::floor(1.5 * rows) + 1 + away) * h, 0}, {0, 1}), rows);
  return out;
}

TEST(CutBlocks, SliversDoNotChangeTheDeflection) {
  const double first = compliance(cut_beside_a_line(10, 1e-1)->equilibrium());
  for (const double away : {1e-2, 1e-4, 1e-6})
    EXPECT_NEAR(compliance(cut_beside_a_line(10, away)->equilibrium()) / first, 1, 2e-5);
}

TEST(CutBlocks, SliversDoNotChangeTheCondition) {
  const auto condition = [](double away) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> found(
        dense(cut_beside_a_line(4, away)->equilibrium().intact()), Eigen::EigenvaluesOnly);
    return found.eigenvalues().tail(1)(0) / found.eigenvalues()(0);
  };
  const double first = condition(1e-1);
  for (const double away : {1e-2, 1e-4, 1e-6}) EXPECT_LT(condition(away), 2 * first);
}

/// Loads, supports and gauges belong to the part on which they stand.
TEST(CutBlocks, PlacesMoveWithTheirPart) {
  CutStructure structure({.subdivision = "{type: grid, columns: 3, rows: 1}"});
  ASSERT_TRUE(structure.cracks().cut(BlockId{1}, {14, 0}, {16, 10}, 0));
  std::vector<double> d = structure.field(Mat2::Zero());
  const std::size_t jump = 6 * structure.body().node_of(JumpId{0}).value();
  d[jump] = 0.3;
  d[jump + 2] = 0.2;
  const auto at = [&](const Vec2& x, const Vec2& along) {
    return displacement_at(structure.body(), {Spot(x.x(), x.y()), {}, {}}, along, {}).value(d, 0);
  };
  const double size = 10;
  EXPECT_EQ(at({12, 10}, {1, 0}), 0) << "left of the cut";
  EXPECT_NEAR(at({18, 10}, {1, 0}), 0.3 - 0.2 / size * 5, 1e-15) << "right of it";
  EXPECT_NEAR(at({18, 10}, {0, 1}), 0.2 / size * 3, 1e-15);
  const Place patch{{}, {}, std::vector<Spot>{Spot(14, 10), Spot(18, 10)}};
  EXPECT_NEAR(displacement_at(structure.body(), patch, {1, 0}, {}).value(d, 0), 0.5 * (0.3 - 0.1), 1e-15);
}

TEST(CutBlocks, SelfWeightActsOnParts) {
  CutStructure structure({.more = "stages: [{loads: [{type: body_force, force: [0, -2]}]}]\n"});
  ASSERT_GE(structure.cut_straight({11.3, 0}, {0.07, 1}), 3);
  const Equilibrium equilibrium = structure.equilibrium();
  const std::vector<double>& f = equilibrium.stages().back().reference;
  for (std::size_t j = 0; j < structure.cracks().num_jumps(); ++j) {
    const auto parts = structure.cracks().parts(structure.cracks().cut_of(JumpId{j}).block);
    ASSERT_EQ(parts.size(), 2u);
    const std::size_t at = 6 * structure.body().node_of(JumpId{j}).value();
    EXPECT_NEAR(f[at + 1], -2 * 0.7 * signed_area(parts[1].outline), 1e-13);
    EXPECT_EQ(f[at], 0);
  }
}

/// A uniform initial stress and the tractions that hold it leave nothing to move.
TEST(CutBlocks, UniformInitialStressIsHeldByItsTractions) {
  CutStructure structure(
      {.more = "stages: [{loads: [{type: initial_stress, xx: 0.3, yy: -0.1, xy: 0.2}]}]\n"});
  ASSERT_GE(cut_some(structure), 9);
  const Equilibrium equilibrium = structure.equilibrium();
  const Loading& loading = equilibrium.stages().back();
  std::vector<double> left = loading.reference, t(2 * equilibrium.num_active());
  for (std::size_t p = 0; p < equilibrium.num_active(); ++p)
    Eigen::Map<Vec2>(t.data() + 2 * p) =
        -equilibrium.point(p).intact_stiffness().cwiseProduct(loading.reference_opening(p));
  equilibrium.scatter_add(t, left);
  Mat2 stress;
  stress << 0.3, 0.2, 0.2, -0.1;
  const Vector held = vector(structure.tractions(stress).force);
  EXPECT_LT((vector(left) + held).norm(), 1e-12 * held.norm());
}

TEST(CutBlocks, PointsOfMoreCutsComeAtTheEndOfTheirGroup) {
  CutStructure structure({});
  ASSERT_GE(structure.cut_straight({11.3, 0}, {0.07, 1}, 2), 2);
  const Equilibrium before = structure.equilibrium();
  ASSERT_GE(structure.cut_straight({20.2, 10}, {-0.2, -1}, 3), 3);
  const Equilibrium after = structure.equilibrium();
  ASSERT_EQ(before.num_active(), 4u);
  ASSERT_EQ(after.num_active(), 10u);
  for (std::size_t p = 0; p < before.num_active(); ++p) {
    EXPECT_EQ(after.point(p).x, before.point(p).x);
    EXPECT_EQ(after.point(p).stiffness, before.point(p).stiffness);
    EXPECT_EQ(after.point(p).cut, before.point(p).cut);
  }
}

/// What a crack sees of a block of second order: σ at a point beside the mean is that of the displacements there.
TEST(CutBlocks, StressVariesInBlocksOfSecondOrder) {
  for (const bool second_order : {true, false}) {
    CutStructure structure({.subdivision = "{type: grid, columns: 12, rows: 4}",
                            .more = second_order ? "kinematics: second_order\n" : ""});
    const Body& body = structure.body();
    const Equilibrium equilibrium = structure.equilibrium();
    const BlockId block(7);
    const auto node = body.gradient_of(block);
    ASSERT_EQ(node.has_value(), second_order);
    const Vec2 x = body.block(block).moments.centroid + Vec2(0.7, -0.4);
    std::vector<double> d(equilibrium.num_unknowns(), 0.0);
    Vec3 expected = Vec3::Zero();
    if (node) {
      const Vec6 g = Vec6::Random();
      Eigen::Map<Vec6>(d.data() + block_unknowns * node->value()) = g;
      const auto u = [&](double along, double up) {
        return Vec2(gradient_motion(body, block, x + Vec2(along, up)) * g);
      };
      const Vec2 by_x = (u(0.5, 0) - u(-0.5, 0)), by_y = (u(0, 0.5) - u(0, -0.5));
      expected = body.material(block).stiffness() * Vec3(by_x.x(), by_y.y(), by_x.y() + by_y.x());
    }
    EXPECT_LE((stress_beside_mean(body, block, x, d) - expected).norm(), 1e-12 * expected.norm());
  }
}

/// Making it anew in place gives what a new one is; references to stages stay good.
TEST(CutBlocks, RemakingInPlaceIsMakingAnew) {
  CutStructure structure({});
  Equilibrium equilibrium = structure.equilibrium();
  const Loading* stage = &equilibrium.stages().back();
  ASSERT_GE(cut_some(structure), 9);
  equilibrium.remake(structure.body(), structure.deck());
  EXPECT_EQ(stage, &equilibrium.stages().back());
  EXPECT_EQ(stage->reference.size(), equilibrium.num_unknowns());
  EXPECT_EQ(dense(equilibrium.intact()), dense(structure.equilibrium().intact()));
}

}  // namespace
}  // namespace dda
