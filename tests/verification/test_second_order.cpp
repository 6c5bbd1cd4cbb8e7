// Blocks of second order: exact for quadratic fields, stable for α > ½, of third order in bending, and not troubled by
// incompressibility.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "models/body/motion.hpp"
#include "models/body/place.hpp"
#include "verification/assemblies.hpp"
#include "verification/cantilever.hpp"

namespace dda::verification {
namespace {

// ---- a quadratic field with its body force -------------------------------------------------------------------------

constexpr double young = 10, poisson = 0.3;

/// u = a + G x + ½ H x x, and the body force −div σ that belongs to it, even.
struct QuadraticField {
  static Vec2 displacement(const Vec2& x) {
    const double s = x.x(), t = x.y();
    return {0.3 * s - 0.2 * t + 0.05 * s * s - 0.04 * s * t + 0.03 * t * t,
            0.1 * s + 0.2 * t - 0.02 * s * s + 0.06 * s * t - 0.05 * t * t};
  }
  static Vec3 strain(const Vec2& x) {
    const double s = x.x(), t = x.y();
    return {0.3 + 0.1 * s - 0.04 * t, 0.2 + 0.06 * s - 0.1 * t,
            -0.2 - 0.04 * s + 0.06 * t + 0.1 - 0.04 * s + 0.06 * t};
  }
  static Mat3 stiffness() {
    Mat3 c;
    c << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
    return young / (1 - poisson * poisson) * c;
  }
  static Vec3 stress(const Vec2& x) { return stiffness() * strain(x); }
  static Vec2 body_force() {
    const Vec3 by_x = stress({1, 0}) - stress({0, 0}), by_y = stress({0, 1}) - stress({0, 0});
    return {-by_x[0] - by_y[2], -by_x[2] - by_y[1]};
  }
};

/// "[a, b]" of a vector linear in (x, y), as formulas.
std::string linear_formulas(const Vec2& constant, const Vec2& by_x, const Vec2& by_y) {
  const auto text = [&](int i) {
    return fmt::format("\"{:.17g} + ({:.17g})*x + ({:.17g})*y\"", constant[i], by_x[i], by_y[i]);
  };
  return "[" + text(0) + ", " + text(1) + "]";
}

std::string traction_on_side(const Drawing& drawing, std::size_t side) {
  const Vec2 edge = (drawing.outline.at(side + 1) - drawing.outline.at(side)).normalized();
  const Vec2 n(edge.y(), -edge.x());
  const auto on = [&](const Vec3& s) {
    return Vec2(s[0] * n.x() + s[2] * n.y(), s[2] * n.x() + s[1] * n.y());
  };
  const Vec3 constant = QuadraticField::stress({0, 0});
  return fmt::format("      - {{type: edge_traction, boundary: side{}, traction: {}}}\n", side,
                     linear_formulas(on(constant), on(QuadraticField::stress({1, 0}) - constant),
                                     on(QuadraticField::stress({0, 1}) - constant)));
}

struct SecondOrderPatch {
  Drawing drawing;
  std::string points = "gauss";
  std::string treatment = "consistent";

  std::string deck() const {
    const Vec2 force = QuadraticField::body_force();
    std::string tractions;
    for (std::size_t i = 0; i < drawing.outline.size(); ++i) tractions += traction_on_side(drawing, i);
    return scene_text(drawing) + fmt::format(R"(
thickness: 2
weak_springs: 0
kinematics: second_order
materials: {{soft: {{type: linear_elastic, young_modulus: {}, poisson_ratio: {}}}}}
interfaces: {{joints: {{between: [soft, soft], treatment: {}, points: {}}}}}
supports: {{pin: {{at: {}, fix: xy}}, roller: {{at: {}, fix: y}}}}
stages:
  - loads:
      - {{type: body_force, force: [{:.17g}, {:.17g}]}}
{})",
                                             young, poisson, treatment, points, at(0), at(1), force.x(),
                                             force.y(), tractions);
  }

 private:
  std::string at(std::size_t corner) const {
    const Vec2& x = drawing.outline.at(corner);
    return fmt::format("[{:.17g}, {:.17g}]", x.x(), x.y());
  }
};

void PrintTo(const SecondOrderPatch& patch, std::ostream* out) {
  *out << patch.drawing.name << ", " << patch.treatment << ", " << patch.points;
}

Vec2 moved(const Body& body, BlockId block, const std::vector<double>& d, const Vec2& x) {
  Vec2 out = Vec2::Zero();
  for (const auto& [node, rows] : motions_at(body, block, x))
    out += rows * Eigen::Map<const Vec6>(d.data() + 6 * node.value());
  return out;
}

/// The rigid motion that brings the exact field to the computed one at two corners of the outline.
Vec2 corrected(const Structure& s, const std::vector<double>& d, const Drawing& drawing, const Vec2& x) {
  const Vec2 &a = drawing.outline.at(0), &b = drawing.outline.at(1);
  const auto off = [&](const Vec2& corner) {
    return Vec2(moved(s.body, blocks_at(s.assembly, corner, 1e-9).front(), d, corner) -
                QuadraticField::displacement(corner));
  };
  const Vec2 shift = off(a), along = b - a, by_turn = off(b) - shift;
  const double turn = cross(along, by_turn) / along.squaredNorm();
  return QuadraticField::displacement(x) + shift + turn * Vec2(-(x - a).y(), (x - a).x());
}

class PatchOfSecondOrder : public testing::TestWithParam<SecondOrderPatch> {};

TEST_P(PatchOfSecondOrder, IsExactForQuadraticFields) {
  const Structure s(GetParam().deck());
  const auto d = intact_response(s.equilibrium);
  double displacement = 0, strain = 0;
  for (std::size_t b = 0; b < s.assembly.num_blocks(); ++b) {
    const Block& block = s.assembly.blocks[b];
    for (const Vec2& x : block.outline.vertices)
      displacement = std::max(
          displacement, (moved(s.body, BlockId{b}, d, x) - corrected(s, d, GetParam().drawing, x)).norm());
    strain = std::max(strain, (strain_of(d, b) - QuadraticField::strain(block.moments.centroid)).norm());
  }
  EXPECT_LT(displacement, 1e-10);
  EXPECT_LT(strain, 1e-10);
}

Drawing grid(const std::string& shape) {
  const Polygon outline = rectangle({0, 0}, {3, 2});
  return {shape,
          {{"soft", outline}},
          outline,
          fmt::format("{{type: grid, columns: 5, rows: 3, shape: {}}}", shape)};
}

Drawing voronoi(int iterations) {
  const Polygon outline = rectangle({0, 0}, {3, 2});
  return {fmt::format("Voronoi {}", iterations),
          {{"soft", outline}},
          outline,
          fmt::format("{{type: voronoi, blocks: 30, seed: 4, iterations: {}}}", iterations)};
}

INSTANTIATE_TEST_SUITE_P(
    All, PatchOfSecondOrder,
    testing::Values(SecondOrderPatch{grid("triangles")}, SecondOrderPatch{grid("triangles"), "gauss_2"},
                    SecondOrderPatch{grid("quads")}, SecondOrderPatch{grid("quads"), "gauss_2"},
                    SecondOrderPatch{voronoi(100)}, SecondOrderPatch{voronoi(0), "gauss_2"}));

// ---- stability -----------------------------------------------------------------------------------------------------

/// A free assembly of two materials; `second` are of second order.
double smallest_eigenvalue(const Drawing& drawing, const std::string& second, double alpha) {
  const Structure s(scene_text(drawing) + fmt::format(R"(
thickness: 1
weak_springs: 0
support_stiffness: 1
kinematics: {}
materials:
  soft: {{type: linear_elastic, young_modulus: 1, poisson_ratio: 0.2}}
  stiff: {{type: linear_elastic, young_modulus: 40, poisson_ratio: 0.2}}
interfaces:
  ss: {{between: [soft, soft], treatment: {{type: consistent, alpha: {}}}}}
  st: {{between: [soft, stiff], treatment: {{type: consistent, alpha: {}}}}}
  tt: {{between: [stiff, stiff], treatment: {{type: consistent, alpha: {}}}}}
supports: {{pin: {{at: [0, 0], fix: xy}}, roller: {{at: [{}, 0], fix: y}}}}
stages: [{{loads: [{{type: edge_traction, boundary: side0, traction: [0, 1]}}]}}]
)",
                                                      second, alpha, alpha, alpha,
                                                      drawing.outline.at(1).x()));
  return smallest_scaled_eigenvalue(s.equilibrium.intact());
}

Drawing slender_stack() {
  Drawing out{"stack", {}, rectangle({0, 0}, {30, 4}), "{type: grid, columns: 1, rows: 1}"};
  for (int i = 0; i < 4; ++i)
    out.regions.emplace_back(i % 2 ? "stiff" : "soft", rectangle({0, 1.0 * i}, {30, i + 1.0}));
  return out;
}

TEST(SecondOrderStability, IsSharpAtOneHalf) {
  EXPECT_GT(smallest_eigenvalue(slender_stack(), "second_order", 0.51), 0);
  EXPECT_LT(smallest_eigenvalue(slender_stack(), "second_order", 0.49), 0);
  EXPECT_GT(smallest_eigenvalue(grid("quads"), "second_order", 0.51), 0);
  EXPECT_GT(smallest_eigenvalue(voronoi(0), "second_order", 0.51), 0);
}

TEST(SecondOrderStability, HoldsBesideBlocksOfFirstOrder) {
  Drawing stack = slender_stack();
  const std::string every_second = "{type: second_order, regions: [region1, region3]}";
  EXPECT_GT(smallest_eigenvalue(stack, every_second, 0.51), 0);
  EXPECT_LT(smallest_eigenvalue(stack, every_second, 0.4), 0);
}

/// Layers of unlike stiffness, ν = 0, pulled: u = σ Σ h/E, whatever the order of which. The springs below give by 1.5e-8.
TEST(SecondOrderStability, SoftLayersKeepTheirCompliance) {
  for (const std::string kinematics : {"second_order", "{type: second_order, regions: [region0, region2]}",
                                       "{type: second_order, regions: [region1, region3]}"}) {
    const Drawing drawing = slender_stack();
    const Structure s(scene_text(drawing) + fmt::format(R"(
thickness: 1
weak_springs: 0
kinematics: {}
support_stiffness: 1.0e+3
materials:
  soft: {{type: linear_elastic, young_modulus: 1.0e-6, poisson_ratio: 0}}
  stiff: {{type: linear_elastic, young_modulus: 1, poisson_ratio: 0}}
supports: {{foot: {{boundary: side0, fix: y}}, pin: {{at: [0, 0], fix: x}}}}
stages: [{{loads: [{{type: edge_traction, boundary: side2, traction: [0, 1.0e-6]}}]}}]
)",
                                                        kinematics));
    const auto d = intact_response(s.equilibrium);
    const BlockId top = blocks_at(s.assembly, {15, 3.9}, 1e-9).front();
    EXPECT_NEAR(moved(s.body, top, d, {15, 4}).y() / (2 + 2e-6 + 1.5e-8), 1, 1e-8) << kinematics;
  }
}

// ---- the cantilever ------------------------------------------------------------------------------------------------

CantileverResult bent(const std::string& subdivision, const std::string& joint = "treatment: consistent",
                      double poisson_ratio = 0.25, bool plane_strain = false) {
  Cantilever beam;
  beam.poisson = poisson_ratio;
  beam.is_plane_strain = plane_strain;
  beam.kinematics = "second_order";
  beam.is_clamped = false;
  return solve_cantilever(beam, subdivision, joint);
}

std::string quads(int columns) {
  return fmt::format("{{type: grid, columns: {}, rows: {}}}", columns, columns / 4);
}

TEST(SecondOrderCantilever, ConvergesWithThirdOrder) {
  const auto coarse = bent(quads(16)), fine = bent(quads(32));
  EXPECT_LE(coarse.error, 1.0e-4 * 1.25);
  EXPECT_LE(fine.error, 7.5e-6 * 1.25);
  EXPECT_GE(std::log2(coarse.error / fine.error), 2.8);
  EXPECT_LE(bent("{type: voronoi, blocks: 64, seed: 1, iterations: 100}").error, 2e-4);
}

TEST(SecondOrderCantilever, IsNotTroubledByIncompressibility) {
  EXPECT_LE(bent(quads(32), "treatment: consistent", 0.499, true).error, 5e-4);
}

/// Cook's membrane: E = 1, ν = 1/3, a shear of 1 on its end, whose middle rises by 23.966 ± 0.003.
TEST(SecondOrderCantilever, CooksMembraneWithin256Blocks) {
  const Structure s(R"(
scene:
  regions: [{name: membrane, material: m, vertices: [[0, 0], [48, 44], [48, 60], [0, 44]]}]
  boundaries: {left: [[0, 44], [0, 0]], right: [[48, 44], [48, 60]]}
  subdivision: {type: grid, columns: 16, rows: 16}
kinematics: second_order
thickness: 1
materials: {m: {type: linear_elastic, young_modulus: 1, poisson_ratio: 0.3333333333333333}}
supports: {wall: {boundary: left, fix: xy}}
stages: [{loads: [{type: edge_traction, boundary: right, traction: [0, 0.0625]}]}]
)");
  const auto d = intact_response(s.equilibrium);
  const Functional rise = displacement_at(s.body, {Spot(48, 52), {}, {}}, {0, 1}, {});
  EXPECT_NEAR(rise.value(d, 0), 23.966, 1e-3 * 23.966);
}

/// Stiff springs at two Gauss points lock blocks of first order and not these.
TEST(SecondOrderCantilever, StiffSpringsDoNotLockIt) {
  EXPECT_LE(bent(quads(32), "treatment: {type: penalty, factor: 1.0e+6}, points: gauss_2").error, 2e-5);
}

TEST(SecondOrderCantilever, MultipliersDoNotLockIt) {
  EXPECT_LE(bent(quads(32), "treatment: lagrange").error, 2e-5);
}

}  // namespace
}  // namespace dda::verification
