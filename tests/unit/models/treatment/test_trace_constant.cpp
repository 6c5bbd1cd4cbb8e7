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

/// Linear stress. A square of side h at ν = 0: 6 E/h, three times that of constant stress; other values by an
/// independent solution of the pencil.
TEST(TraceConstant, OfLinearStress) {
  const double h = 2, e = 5;
  const Block square = block_of({{1, 1}, {1 + h, 1}, {1 + h, 1 + h}, {1, 1 + h}});
  EXPECT_NEAR(second_order_trace_constant(square, isotropic(e, 0)) / (6 * e / h), 1, 1e-13);
  EXPECT_NEAR(second_order_trace_constant(square, isotropic(e, 0.25)) / (6.5914 * e / h), 1, 2e-5);
  std::vector<Vec2> hexagon;
  for (int i = 0; i < 6; ++i) hexagon.emplace_back(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3));
  EXPECT_NEAR(second_order_trace_constant(block_of(hexagon), isotropic(1, 0.25)) / 3.9465, 1, 2e-5);
}

/// A slender rectangle at ν = 0: σ linear across it counts three times.
TEST(TraceConstant, OfLinearStressInASlenderRectangle) {
  const Block slender = block_of({{0, 0}, {0.1, 0}, {0.1, 3}, {0, 3}});
  EXPECT_NEAR(second_order_trace_constant(slender, isotropic(4, 0)) / (3 * 2 * 4 / 0.1), 1, 1e-12);
}

/// Across the middle of a square at ν = 0 the stress that is linear along the line counts; σ = x is there no more than
/// elsewhere: c_Γ of σxx = 1 is E/h, of σxx = y the same.
TEST(TraceConstant, OfALineUnderLinearStressIsAtLeastThatOfConstantStress) {
  const double h = 2, e = 5;
  const Block square = block_of({{0, 0}, {h, 0}, {h, h}, {0, h}});
  const Mat3 c = isotropic(e, 0);
  EXPECT_NEAR(second_order_line_trace_constant({h / 2, 0}, {h / 2, h}, square, c) / (e / h), 1, 1e-13);
  const double along_side = second_order_line_trace_constant({0, 0}, {0, h}, square, c);
  EXPECT_NEAR(along_side / (4 * e / h), 1, 1e-13)
      << "σxx = 1 − 3 x/h from the middle, max of (1 + 3)²/(1 + 3)";
}

}  // namespace
}  // namespace dda
