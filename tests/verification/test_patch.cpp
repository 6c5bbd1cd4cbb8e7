// Patch test E1: uniform stress on any assembly of intact blocks gives the strains C⁻¹σ.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numeric>

#include "verification/assemblies.hpp"
#include "verification/stepped.hpp"

namespace dda::verification {
namespace {

constexpr double young = 27500, poisson = 0.2;

/// Three independent states (σx, σy, τxy).
const std::vector<Vec3> states{{2, 0, 0}, {0, -1, 0}, {0, 0, 1.5}};

/// C⁻¹σ written out, independent of the material's own matrix.
Vec3 strain_of_stress(const Vec3& stress, bool plane_strain) {
  const double e = plane_strain ? young / (1 - poisson * poisson) : young;
  const double nu = plane_strain ? poisson / (1 - poisson) : poisson;
  return {(stress[0] - nu * stress[1]) / e, (stress[1] - nu * stress[0]) / e, 2 * (1 + nu) * stress[2] / e};
}

/// Linear displacement field with the given strain that keeps `origin` in place and `other` at its height.
struct LinearField {
  Vec3 strain;
  Vec2 origin, other;

  Vec2 operator()(const Vec2& x) const {
    const Vec2 r = x - origin, b = other - origin;
    const double turn = -(strain[1] * b.y() + 0.5 * strain[2] * b.x()) / b.x();
    return {strain[0] * r.x() + (0.5 * strain[2] - turn) * r.y(),
            (0.5 * strain[2] + turn) * r.x() + strain[1] * r.y()};
  }
};

std::string tractions(const Drawing& drawing, const Vec3& stress) {
  std::string out;
  for (std::size_t i = 0; i < drawing.outline.size(); ++i) {
    const Vec2 edge = (drawing.outline.at(i + 1) - drawing.outline.at(i)).normalized();
    const Vec2 n(edge.y(), -edge.x());
    out += fmt::format("      - {{type: edge_traction, boundary: side{}, traction: [{:.17g}, {:.17g}]}}\n", i,
                       stress[0] * n.x() + stress[2] * n.y(), stress[2] * n.x() + stress[1] * n.y());
  }
  return out;
}

/// Drives every corner of the outline to its exact place, but where the supports hold it there: the first, and the
/// height of the second.
std::string driven_corners(const Drawing& drawing, const LinearField& field) {
  std::string out;
  for (std::size_t i = 1; i < drawing.outline.size(); ++i)
    for (const Vec2& l : i == 1 ? std::vector{Vec2(1, 0)} : std::vector{Vec2(1, 0), Vec2(0, 1)}) {
      const Vec2& x = drawing.outline.at(i);
      out += fmt::format(
          "      - {{type: prescribed_displacement, at: [{:.17g}, {:.17g}], direction: [{}, {}], "
          "displacement: {:.17g}}}\n",
          x.x(), x.y(), l.x(), l.y(), l.dot(field(x)));
    }
  return out;
}

struct Patch {
  Drawing drawing;
  std::string treatment = "consistent";
  std::string points = "gauss";
  bool plane_strain = false;
  bool drive_corners = false;

  LinearField field(const Vec3& stress) const {
    return {strain_of_stress(stress, plane_strain), drawing.outline.at(0), drawing.outline.at(1)};
  }
  std::string deck(const Vec3& stress) const {
    const auto at = [](const Vec2& x) { return points_text({x}).substr(1, points_text({x}).size() - 2); };
    return scene_text(drawing) + fmt::format(R"(
thickness: 10
weak_springs: 0
support_stiffness: 100
plane: {}
materials:
  concrete: {{type: linear_elastic, young_modulus: {}, poisson_ratio: {}}}
interfaces:
  joints: {{between: [concrete, concrete], treatment: {}, points: {}}}
supports:
  pin: {{at: {}, fix: xy}}
  roller: {{at: {}, fix: y}}
stages:
  - loads:
{}{})",
                                             plane_strain ? "strain" : "stress", young, poisson, treatment,
                                             points, at(drawing.outline.at(0)), at(drawing.outline.at(1)),
                                             tractions(drawing, stress),
                                             drive_corners ? driven_corners(drawing, field(stress)) : "");
  }
};

void PrintTo(const Patch& patch, std::ostream* out) {
  *out << patch.drawing.name << ", " << patch.treatment << ", " << patch.points
       << (patch.plane_strain ? ", plane strain" : "") << (patch.drive_corners ? ", driven corners" : "");
}

/// Largest error of a strain component of the first blocks of `d`, relative to the largest strain.
double strain_error(const Patch& patch, const Vec3& stress, const std::vector<double>& d,
                    std::size_t blocks) {
  const Vec3 expected = strain_of_stress(stress, patch.plane_strain);
  double worst = 0;
  for (std::size_t i = 0; i < blocks; ++i)
    worst = std::max(worst, (strain_of(d, i) - expected).cwiseAbs().maxCoeff());
  return worst / expected.cwiseAbs().maxCoeff();
}

double strain_error(const Patch& patch, const Vec3& stress) {
  const Structure structure(patch.deck(stress));
  return strain_error(patch, stress, intact_response(structure.equilibrium), structure.assembly.num_blocks());
}

/// Largest error of a centroid's displacement, relative to the largest displacement.
double displacement_error(const Patch& patch, const Vec3& stress) {
  const Structure structure(patch.deck(stress));
  const auto d = intact_response(structure.equilibrium);
  const LinearField field = patch.field(stress);
  double worst = 0, largest = 0;
  for (std::size_t i = 0; i < structure.assembly.num_blocks(); ++i) {
    const Vec2 expected = field(structure.assembly.blocks[i].moments.centroid);
    worst = std::max(worst, (Vec2(d[6 * i], d[6 * i + 1]) - expected).norm());
    largest = std::max(largest, expected.norm());
  }
  return worst / largest;
}

Drawing beam(const std::string& name, const std::string& subdivision) {
  const Polygon outline = rectangle({0, 0}, {300, 100});
  return {name, {{"concrete", outline}}, outline, subdivision};
}

/// A region beside two that are half as high: their rows end in the middle of its sides.
Drawing t_joints() {
  return {"T-joints",
          {{"concrete", rectangle({0, 0}, {100, 90})},
           {"concrete", rectangle({100, 0}, {230, 45})},
           {"concrete", rectangle({100, 45}, {230, 90})}},
          rectangle({0, 0}, {230, 90}),
          "{type: grid, columns: 4, rows: 3}"};
}

Drawing random_polygons(std::uint64_t seed) {
  const Polygon outline = random_convex(7, {150, 100}, seed);
  Drawing out{fmt::format("random polygons {}", seed), {}, outline};
  for (Polygon& piece : random_pieces(outline, 40, seed))
    out.regions.emplace_back("concrete", std::move(piece));
  return out;
}

/// An L and a U that hook into each other, and what fills the rectangle around them.
Drawing non_convex() {
  const Polygon el{{{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 60}, {0, 60}}};
  const Polygon u{{{20, 20}, {60, 20}, {60, 60}, {45, 60}, {45, 35}, {35, 35}, {35, 60}, {20, 60}}};
  const Polygon tongue{{{35, 35}, {45, 35}, {45, 60}, {35, 60}}};
  return {
      "non-convex", {{"concrete", el}, {"concrete", u}, {"concrete", tongue}}, rectangle({0, 0}, {60, 60})};
}

std::vector<Drawing> drawings() {
  return {beam("grid", "{type: grid, columns: 6, rows: 3}"),
          beam("grid of triangles", "{type: grid, columns: 6, rows: 3, shape: triangles}"),
          beam("gmsh triangles", "{type: triangles, size: 30}"),
          beam("gmsh quads", "{type: quads, size: 30}"),
          beam("Voronoi", "{type: voronoi, blocks: 50, seed: 3}"),
          beam("Voronoi of random sites", "{type: voronoi, blocks: 50, seed: 3, iterations: 0}"),
          t_joints(),
          non_convex(),
          random_polygons(1),
          random_polygons(2)};
}

class PatchOf : public testing::TestWithParam<Drawing> {};

TEST_P(PatchOf, ConsistentJointsIsExact) {
  const std::vector<Patch> patches{{GetParam()},
                                   {GetParam(), "{type: consistent, alpha: 20}"},
                                   {GetParam(), "consistent", "gauss", true, false},
                                   {GetParam(), "consistent", "gauss", false, true},
                                   {GetParam(), "consistent", "gauss", true, true}};
  for (const Patch& patch : patches)
    for (const Vec3& stress : states) {
      EXPECT_LT(strain_error(patch, stress), 1e-10) << testing::PrintToString(patch) << stress.transpose();
      EXPECT_LT(displacement_error(patch, stress), 1e-10)
          << testing::PrintToString(patch) << stress.transpose();
    }
}

/// A joint's perturbation δ = 1e-9 adds the compliance δ/(10 E/h), 1e-10 of a block's; solving for redundant
/// multipliers costs the digits that δ leaves, round-off/δ = 1e-7.
TEST_P(PatchOf, LagrangeJointsIsExact) {
  for (const std::string points : {"gauss", "midpoint"})
    for (const Vec3& stress : states)
      EXPECT_LT(strain_error({GetParam(), "{type: lagrange, perturbation: 1e-9}", points}, stress), 1e-7)
          << points << ", " << stress.transpose();
}

/// Largest stiffness of a joint in units of the smallest E/(distance of the centroids).
double largest_factor(const Equilibrium& equilibrium) {
  double unit = equilibrium.point(0).spring_unit, stiffness = 0;
  for (std::size_t p = 0; p < equilibrium.num_points(); ++p) {
    unit = std::min(unit, equilibrium.point(p).spring_unit);
    stiffness = std::max(stiffness, equilibrium.point(p).stiffness);
  }
  return stiffness / unit;
}

/// The gap left in a joint is at most 1e-10 of the largest block's deformation; the traction may be off by k
/// times as much, and a slender block strains some ten times that. A gap shrinks by k_body/(k_body + k) in an
/// iteration, and k_body is large where a short side lies between large blocks: k is larger than by default.
TEST_P(PatchOf, AugmentedLagrangianJointsIsExact) {
  constexpr double tolerance = 1e-10;
  for (const Vec3& stress : states) {
    const Patch patch{GetParam(), "{type: augmented_lagrangian, factor: 1000}"};
    Stepped stepped(patch.deck(stress), {.tolerance = tolerance});
    const Attempt tried = stepped.to(1);
    ASSERT_TRUE(tried.converged) << tried.reason;
    EXPECT_GE(tried.multiplier_iterations, 1);
    const double allowed = 10 * tolerance * largest_factor(stepped.system().equilibrium());
    ASSERT_LT(allowed, 1e-3);
    EXPECT_LT(strain_error(patch, stress, stepped.state().d, stepped.state().d.size() / 6), allowed)
        << stress.transpose();
  }
}

/// Work of the tractions beyond σ:C⁻¹:σ V, relative to it: what the joints' own compliance takes.
double excess_work(const Patch& patch, const Vec3& stress) {
  const Structure structure(patch.deck(stress));
  const auto& force = structure.equilibrium.stages().back().reference;
  const auto d = intact_response(structure.equilibrium);
  const double exact = strain_of_stress(stress, patch.plane_strain).dot(stress) *
                       signed_area(patch.drawing.outline) * structure.body.thickness;
  return std::inner_product(force.begin(), force.end(), d.begin(), -exact) / exact;
}

TEST_P(PatchOf, PenaltyJointsErrsByTheirCompliance) {
  for (const std::string points : {"gauss", "vertices"})
    for (const Vec3& stress : states) {
      const Patch soft{GetParam(), "{type: penalty, factor: 3e4}", points};
      const Patch stiff{GetParam(), "{type: penalty, factor: 3e5}", points};
      EXPECT_NEAR(excess_work(soft, stress) / excess_work(stiff, stress), 10, 0.1)
          << points << ", stress " << stress.transpose();
    }
}

INSTANTIATE_TEST_SUITE_P(All, PatchOf, testing::ValuesIn(drawings()));

/// Supports along a boundary are springs: under a uniform traction they must not bend an edge of unequal
/// sides.
TEST(PatchUnderDefaults, VoronoiPlateOnSupportedEdgesKeepsUniformStrain) {
  const Trace trace = follow(R"(
scene:
  regions:
    - {name: plate, material: steel, vertices: [[0, 0], [100, 0], [100, 60], [0, 60]]}
  boundaries: {left: [[0, 0], [0, 60]], right: [[100, 0], [100, 60]], bottom: [[0, 0], [100, 0]]}
  subdivision: {type: voronoi, blocks: 50}
thickness: 10
materials: {steel: {type: linear_elastic, young_modulus: 1000, poisson_ratio: 0.3}}
supports: {left: {boundary: left, fix: x}, bottom: {boundary: bottom, fix: y}}
stages:
  - loads: [{type: edge_traction, boundary: right, traction: [1, 0]}]
)");
  const std::vector<double>& d = trace.last().state.d;
  for (std::size_t block = 0; block < d.size() / 6; ++block)
    EXPECT_LT((strain_of(d, block) - Vec3(1e-3, -3e-4, 0)).cwiseAbs().maxCoeff(), 1e-10 * 1e-3) << block;
}

}  // namespace
}  // namespace dda::verification
