#include "models/treatment/trace_constant.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace dda {

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

}  // namespace dda
