// Cantilever E2: convergence to the exact field, and what penalty joints make of it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "verification/cantilever.hpp"

namespace dda::verification {
namespace {

constexpr std::size_t levels = 3;

/// A shape of blocks, coarse to fine with twice as many along each side.
struct Family {
  std::string name;
  std::array<std::string, levels> subdivisions;
};

Family grid(const std::string& shape) {
  const auto level = [&](int columns) {
    return fmt::format("{{type: grid, columns: {}, rows: {}, shape: {}}}", columns, columns / 4, shape);
  };
  return {shape, {level(16), level(32), level(64)}};
}

Family voronoi() {
  const auto level = [](int blocks) {
    return fmt::format("{{type: voronoi, blocks: {}, seed: 1, iterations: 100}}", blocks);
  };
  return {"Voronoi", {level(64), level(256), level(1024)}};
}

struct ConvergenceCase {
  Family family;
  double alpha = 0;
  std::array<double, levels> published;  ///< relative L2 errors of the formulation's table
};

void PrintTo(const ConvergenceCase& c, std::ostream* out) { *out << c.family.name << ", alpha " << c.alpha; }

class CantileverConvergence : public testing::TestWithParam<ConvergenceCase> {};

double order(const CantileverResult& coarse, const CantileverResult& fine) {
  const double sizes = std::sqrt(static_cast<double>(fine.blocks) / static_cast<double>(coarse.blocks));
  return std::log(coarse.error / fine.error) / std::log(sizes);
}

TEST_P(CantileverConvergence, IsOfSecondOrderWithErrorsOfThePublishedSize) {
  const Cantilever beam;
  const std::string joint = fmt::format("treatment: {{type: consistent, alpha: {}}}", GetParam().alpha);
  std::array<CantileverResult, levels> results;
  for (std::size_t i = 0; i < levels; ++i) {
    results[i] = solve_cantilever(beam, GetParam().family.subdivisions[i], joint);
    EXPECT_LT(results[i].error, 1.25 * GetParam().published[i]);
    EXPECT_GT(results[i].error, 0.6 * GetParam().published[i]);
    EXPECT_NEAR(results[i].tip, beam.tip_deflection(), 1.2 * results[i].error * beam.tip_deflection());
  }
  // At α = 2 blocks of H/4 are still far from the asymptote.
  if (GetParam().alpha <= 1) {
    EXPECT_GT(order(results[0], results[1]), 1.7);
  }
  EXPECT_GT(order(results[1], results[2]), 1.7);
}

INSTANTIATE_TEST_SUITE_P(All, CantileverConvergence,
                         testing::Values(ConvergenceCase{grid("quads"), 0.51, {.096, .027, .0069}},
                                         ConvergenceCase{grid("quads"), 0.6, {.122, .035, .0088}},
                                         ConvergenceCase{grid("quads"), 1, {.215, .065, .017}},
                                         ConvergenceCase{grid("quads"), 2, {.369, .133, .037}},
                                         ConvergenceCase{grid("triangles"), 0.51, {.049, .014, .0037}},
                                         ConvergenceCase{grid("triangles"), 0.6, {.060, .017, .0044}},
                                         ConvergenceCase{grid("triangles"), 1, {.089, .025, .0064}},
                                         ConvergenceCase{grid("triangles"), 2, {.117, .034, .0086}},
                                         ConvergenceCase{voronoi(), 0.51, {.068, .022, .0052}},
                                         ConvergenceCase{voronoi(), 0.6, {.081, .026, .0059}},
                                         ConvergenceCase{voronoi(), 1, {.124, .039, .0087}},
                                         ConvergenceCase{voronoi(), 2, {.207, .069, .015}}));

TEST(Cantilever, ExactTipDeflectionIsThePublishedOne) {
  EXPECT_NEAR(Cantilever{}.tip_deflection(), 0.0967273, 5e-8);
}

double penalty_error(const std::string& subdivision, double factor) {
  return solve_cantilever({}, subdivision,
                          fmt::format("treatment: {{type: penalty, factor: {}}}, points: vertices", factor))
      .error;
}

TEST(CantileverWithPenalty, LowStiffnessIsAComplianceThatNoRefinementCures) {
  for (const Family& family : {grid("quads"), grid("triangles"), voronoi()}) {
    std::array<double, levels> errors;
    for (std::size_t i = 0; i < levels; ++i) errors[i] = penalty_error(family.subdivisions[i], 1);
    EXPECT_GT(errors[1], errors[0]) << family.name;
    EXPECT_GT(errors[2], errors[1]) << family.name;
    EXPECT_GT(errors[2], 0.9) << family.name;
  }
}

TEST(CantileverWithPenalty, HighStiffnessLocksQuadsAndVoronoi) {
  for (const Family& family : {grid("quads"), voronoi()})
    for (const std::string& subdivision : family.subdivisions)
      EXPECT_GT(penalty_error(subdivision, 1e4), 0.9) << subdivision;
}

TEST(CantileverWithPenalty, HighStiffnessMakesTrianglesFiniteElements) {
  const Family family = grid("triangles");
  EXPECT_GT(penalty_error(family.subdivisions[1], 1e4) / penalty_error(family.subdivisions[2], 1e4), 3.2);
  EXPECT_LT(penalty_error(family.subdivisions[2], 1e4), 0.015);
}

TEST(CantileverWithPenalty, OneLayerTiedAtItsVerticesCannotBend) {
  const Cantilever beam;
  const double modulus = beam.young / (2 * (1 + beam.poisson));
  const double tip = beam.shear * beam.length / (modulus * beam.height * beam.thickness);
  EXPECT_NEAR(tip, 3.491e-3, 5e-7);
  for (const int columns : {1, 4, 16, 64}) {
    const Structure structure(beam.deck(fmt::format("{{type: grid, columns: {}, rows: 1}}", columns),
                                        "treatment: {type: penalty, factor: 1e7}, points: vertices") +
                              "support_stiffness: 1e9\n");
    const auto d = intact_response(structure.equilibrium);
    const Eigen::Map<const Vec6> last(d.data() + d.size() - 6);
    const Vec2 corner = Vec2(beam.length, 0) - structure.assembly.blocks.back().moments.centroid;
    // The deck pulls with a traction of 1.
    const double moved = (displacement_rows(corner) * last).y() * beam.shear / (beam.height * beam.thickness);
    EXPECT_NEAR(moved / tip, 1, 1e-4) << columns << " blocks";
  }
}

}  // namespace
}  // namespace dda::verification
