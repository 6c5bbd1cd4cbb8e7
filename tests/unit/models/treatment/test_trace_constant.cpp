#include <gtest/gtest.h>

#include "models/treatment/trace_constant.hpp"

namespace dda {
namespace {

Block block_of(std::vector<Vec2> vertices) {
  const Polygon outline{std::move(vertices)};
  return {outline, moments(outline), 0};
}

Mat3 isotropic(double e, double nu) {
  Mat3 c;
  c << 1, nu, 0, nu, 1, 0, 0, 0, (1 - nu) / 2;
  return e / (1 - nu * nu) * c;
}

/// Square of side a: ∮|σn|² = 2a (σx² + σy² + 2τ²) and A σ:C⁻¹:σ = a²/E (σx² + σy² − 2ν σxσy + 2(1+ν) τ²);
/// σx = σy is the worst for ν > 0, pure shear or σx = −σy for ν < 0: c = 2E/(a (1 − |ν|)).
TEST(TraceConstant, SquareInClosedForm) {
  const double a = 2, e = 5;
  const Block square = block_of({{1, 1}, {1 + a, 1}, {1 + a, 1 + a}, {1, 1 + a}});
  for (const double nu : {0.0, 0.2, 0.45})
    EXPECT_NEAR(trace_constant(square, isotropic(e, nu)) / (2 * e / (a * (1 - nu))), 1, 1e-13);
  EXPECT_NEAR(trace_constant(square, isotropic(e, -0.3)) / (2 * e / (a * 0.7)), 1, 1e-13);
}

/// Equilateral triangle of side a, ν = 0: ∮ n nᵀ ds = (3a/2) 1, so ∮|σn|² = (3a/2) σ:σ; with A = √3 a²/4 the
/// ratio is E 3a/2 / A = 2√3 E/a for every σ.
TEST(TraceConstant, EquilateralTriangleInClosedForm) {
  const double a = 0.7, e = 3, h = std::sqrt(3.0) / 2 * a;
  const Block triangle = block_of({{0, 0}, {a, 0}, {a / 2, h}});
  EXPECT_NEAR(trace_constant(triangle, isotropic(e, 0)) / (2 * std::sqrt(3.0) * e / a), 1, 1e-13);
}

/// A rectangle a × b, a < b, ν = 0: σ along the short sides' normal decides, c = 2b E/(a b).
TEST(TraceConstant, SlenderRectangleInClosedForm) {
  const Block slender = block_of({{0, 0}, {0.1, 0}, {0.1, 3}, {0, 3}});
  EXPECT_NEAR(trace_constant(slender, isotropic(4, 0)) / (2 * 4 / 0.1), 1, 1e-13);
}

TEST(TraceConstant, ScalesWithStiffnessOverLength) {
  const Block small = block_of({{0, 0}, {1, 0.2}, {0.9, 1}, {0.3, 1.3}});
  std::vector<Vec2> vertices;
  for (const Vec2& x : small.outline.vertices) vertices.push_back(10 * x);
  const Mat3 c = isotropic(1, 0.2);
  EXPECT_NEAR(trace_constant(block_of(vertices), 7 * c) / trace_constant(small, c), 0.7, 1e-12);
}

}  // namespace
}  // namespace dda
