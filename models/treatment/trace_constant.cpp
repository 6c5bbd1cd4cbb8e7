#include "models/treatment/trace_constant.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace dda {
namespace {

using Mat9 = Eigen::Matrix<double, 9, 9>;

/// Adds ∫ |σ n|² ds over a straight line, σ = (σ0, a ∂σ/∂x, a ∂σ/∂y) by components, a² the area of the block.
void add_line(const Vec2& start, const Vec2& end, const Block& block, Mat9& out) {
  const double size = std::sqrt(block.moments.area);
  const Vec2 edge = end - start, normal = Vec2(edge.y(), -edge.x()) / edge.norm();
  const auto rows = traction_rows(normal);
  const Mat3 of_traction = rows.transpose() * rows;
  const Vec2 middle = ((start + end) / 2 - block.moments.centroid) / size, half = edge / (2 * size);
  const Vec3 m(1, middle.x(), middle.y()), r(0, half.x(), half.y());
  const Mat3 of_place = edge.norm() * (m * m.transpose() + r * r.transpose() / 3);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out.block<3, 3>(3 * i, 3 * j) += of_traction(i, j) * of_place;
}

/// Its largest ratio to ∫ σ:C⁻¹:σ dA.
double largest_ratio(const Mat9& boundary, const Block& block, const Mat3& stiffness) {
  const Mat3 compliance = stiffness.inverse();
  Mat3 of_place = Mat3::Zero();
  of_place(0, 0) = block.moments.area;
  of_place.bottomRightCorner<2, 2>() = block.moments.second / block.moments.area;
  Mat9 energy;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) energy.block<3, 3>(3 * i, 3 * j) = compliance(i, j) * of_place;
  return Eigen::GeneralizedSelfAdjointEigenSolver<Mat9>(boundary, energy, Eigen::EigenvaluesOnly)
      .eigenvalues()(8);
}

}  // namespace

double trace_constant(const Block& block, const Mat3& stiffness) {
  Mat3 boundary = Mat3::Zero();
  const auto& v = block.outline.vertices;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const Vec2 edge = v[(i + 1) % v.size()] - v[i];
    const double length = edge.norm();
    const Vec2 n(edge.y() / length, -edge.x() / length);
    Eigen::Matrix<double, 2, 3> rows;
    rows << n.x(), 0, n.y(), 0, n.y(), n.x();
    boundary += length * rows.transpose() * rows;
  }
  const Mat3 energy = block.moments.area * stiffness.inverse();
  return Eigen::GeneralizedSelfAdjointEigenSolver<Mat3>(boundary, energy, Eigen::EigenvaluesOnly)
      .eigenvalues()(2);
}

double line_trace_constant(double length, const Vec2& normal, double area, const Mat3& stiffness) {
  const auto rows = traction_rows(normal);
  const Mat2 acoustic = rows * stiffness * rows.transpose();
  return length / area *
         Eigen::SelfAdjointEigenSolver<Mat2>(acoustic, Eigen::EigenvaluesOnly).eigenvalues()(1);
}

double second_order_trace_constant(const Block& block, const Mat3& stiffness) {
  Mat9 boundary = Mat9::Zero();
  const Polygon& outline = block.outline;
  for (std::size_t i = 0; i < outline.size(); ++i)
    add_line(outline.at(i), outline.at(i + 1), block, boundary);
  return largest_ratio(boundary, block, stiffness);
}

double second_order_line_trace_constant(const Vec2& start, const Vec2& end, const Block& block,
                                        const Mat3& stiffness) {
  Mat9 line = Mat9::Zero();
  add_line(start, end, block, line);
  return largest_ratio(line, block, stiffness);
}

}  // namespace dda
